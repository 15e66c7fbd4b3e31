import { createReadStream } from "node:fs";
import { readFile, readdir, stat } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";

/** The built page. */
export const DIST = path.resolve(process.env.ROSTO_DIST ?? path.join(import.meta.dirname, "../../dist"));

/** Folder of the version in a build. @param {string} folder */
export async function versionIn(folder) {
  const version = (await readdir(folder)).find((name) => /^[0-9a-f]{16}$/.test(name));
  if (!version) throw new Error(`${folder} holds no version; build it with cargo xtask dist`);
  return version;
}

/** Path of a file of the built version, relative to the page. @param {string} name */
export const inVersion = async (name) => `${await versionIn(DIST)}/${name}`;

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
  let rules = await headersIn(folder);
  let served = folder;
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    for (const { pattern, headers } of rules) {
      if (pattern.test(`/${pathname.slice(below.length)}`)) for (const [name, value] of headers) response.setHeader(name, value);
    }
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
    deploy: async (next) => {
      rules = await headersIn(next);
      served = next;
    },
    url: `http://127.0.0.1:${server.address().port}${below}`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

/**
 * Rules of a folder's `_headers`; without that file, only the cache rule.
 *
 * @param {string} folder
 * @returns {Promise<{ pattern: RegExp, headers: [name: string, value: string][] }[]>}
 */
async function headersIn(folder) {
  const text = await readFile(path.join(folder, "_headers"), "utf8").catch(() => "/*\n  Cache-Control: no-cache\n");
  const blocks = [...text.matchAll(/^(\/\S*)\n((?: {2}.*\n)+)/gm)];
  return blocks.map(([, path, lines]) => ({
    pattern: new RegExp(`^${path.replaceAll("*", ".*")}$`),
    headers: [...lines.matchAll(/^ {2}([\w-]+): (.*)$/gm)].map(([, name, value]) => [name, value]),
  }));
}
