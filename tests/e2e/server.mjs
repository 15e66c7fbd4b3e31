import { createReadStream } from "node:fs";
import { readFile, stat } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";

/** The built page. */
export const DIST = path.resolve(process.env.ROSTO_DIST ?? path.join(import.meta.dirname, "../../dist"));

const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".mjs": "text/javascript",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/**
 * Serves a folder below a path, with the headers of its `_headers` file, as a static host does.
 *
 * @typedef {(name: string, response: import("node:http").ServerResponse) => boolean} Interceptor handles a request for a
 *   file ("" for the page); returns true if it answers the request itself
 *
 * @param {string} folder
 * @param {string} below for example "/some/path/"
 */
export async function serve(folder, below) {
  /** @type {Interceptor | undefined} */
  let interceptor;
  const headers = await headersIn(folder);
  let served = folder;
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    for (const [name, value] of headers) response.setHeader(name, value);
    if (interceptor?.(pathname.slice(below.length), response)) return;
    const file = path.join(served, decodeURIComponent(pathname.slice(below.length)) || "index.html");
    const found = await stat(file).catch(() => undefined);
    if (!pathname.startsWith(below) || !found?.isFile()) return response.writeHead(404).end();
    const type = TYPES[path.extname(file)] ?? "application/octet-stream";
    response.writeHead(200, { "content-type": type, "content-length": found.size });
    createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    /** @param {Interceptor} [by] undefined restores normal service */
    intercept: (by) => (interceptor = by),
    /** @param {string} next folder to serve from now on */
    deploy: (next) => (served = next),
    url: `http://127.0.0.1:${server.address().port}${below}`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

/**
 * Headers that `_headers` sets for all files; without that file, only the cache rule.
 *
 * @param {string} folder
 * @returns {Promise<[name: string, value: string][]>}
 */
async function headersIn(folder) {
  const text = await readFile(path.join(folder, "_headers"), "utf8").catch(() => "/*\n  Cache-Control: no-cache\n");
  return [...text.matchAll(/^ {2}([\w-]+): (.*)$/gm)].map(([, name, value]) => [name, value]);
}
