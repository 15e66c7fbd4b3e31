import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFile, mkdir, readFile, readdir } from "node:fs/promises";
import { homedir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";
import { test } from "./fixtures.mjs";
import { DIST } from "./server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const HOOK = path.join(ROOT, "web/list-for-offline.mjs");
const COMPARE = path.join(ROOT, "web/compare-published.mjs");
const run = promisify(execFile);

test("the page is served with its security headers, and all host configurations list the same ones", async ({ visitor }) => {
  const policy = await visitor.page.getAttribute("meta[http-equiv='Content-Security-Policy']", "content");
  for (const name of ["./", "js/worker/vision-worker.js", "service-worker.js", "wasm/rosto-vision-web_bg.wasm"]) {
    const headers = await visitor.page.evaluate(async (name) => Object.fromEntries((await fetch(name)).headers), name);
    assert.equal(headers["content-security-policy"], `${policy}; frame-ancestors 'none'`);
    assert.equal(headers["cross-origin-opener-policy"], "same-origin");
    assert.equal(headers["x-content-type-options"], "nosniff");
    assert.equal(headers["referrer-policy"], "no-referrer");
    assert.equal(headers["cache-control"], "no-cache");
    assert.equal(headers["permissions-policy"], "camera=(self), microphone=(), geolocation=(), display-capture=(), fullscreen=()");
  }

  const headersIn = async (name, pattern) => [...String(await readFile(path.join(DIST, name))).matchAll(pattern)].map(([, name, value]) => [name, value]);
  const plain = await headersIn("_headers", /^ {2}([\w-]+): (.*)$/gm);
  assert.equal(plain.length, 6);
  assert.deepEqual(await headersIn(".htaccess", /^ {2}Header always set ([\w-]+) "(.*)"$/gm), plain);
  assert.deepEqual(await headersIn("nginx.conf", /^add_header ([\w-]+) "(.*)" always;$/gm), plain);
  const { headers } = JSON.parse(String(await readFile(path.join(DIST, "vercel.json"))));
  assert.deepEqual(headers[0].headers.map(({ key, value }) => [key, value]), plain);
});

test("other pages cannot frame the page", async ({ page }) => {
  const another = await page.context().newPage();
  await another.setContent(`<iframe src="${page.url()}"></iframe>`);
  const frame = await (await another.waitForSelector("iframe")).contentFrame();
  await frame.waitForLoadState();
  assert.equal(await frame.locator("#stage").count(), 0);
});

test("the list contains the SHA-256 of each file, and the page contains the list's", async () => {
  const list = await readFile(path.join(DIST, "integrity.json"));
  const { files } = JSON.parse(String(list));
  const known = new Set(["index.html", "service-worker.js", "integrity.json", "_headers", "vercel.json", "nginx.conf"]);
  const there = (await filesOf(DIST)).filter((name) => !name.startsWith(".") && !name.endsWith(".d.ts") && !known.has(name));
  assert.deepEqual(Object.keys(files), there);
  for (const name of there) assert.equal(files[name], integrity(await readFile(path.join(DIST, name))), name);
  const page = String(await readFile(path.join(DIST, "index.html")));
  assert.ok(page.includes(`<meta name="integrity" content="${integrity(list)}">`));
  const stored = /^const OFFLINE = (.*);$/m.exec(String(await readFile(path.join(DIST, "service-worker.js"))))?.[1] ?? "";
  const { version, files: kept, fallback } = JSON.parse(stored);
  assert.deepEqual({ ...kept, ...fallback }, { ...files, "integrity.json": integrity(list) });
  assert.ok(page.includes(`<meta name="version" content="${version}">`));
});

test("the list does not depend on the order of files or on repeated runs", async () => {
  const folder = test.info().outputPath("dist");
  for (const name of (await filesOf(DIST)).reverse()) {
    await mkdir(path.dirname(path.join(folder, name)), { recursive: true });
    await copyFile(path.join(DIST, name), path.join(folder, name));
  }
  for (let times = 0; times < 2; times += 1) {
    await run("node", [HOOK], { env: { ...process.env, TRUNK_STAGING_DIR: folder } });
    for (const name of await filesOf(DIST)) {
      assert.ok((await readFile(path.join(folder, name))).equals(await readFile(path.join(DIST, name))), name);
    }
  }
});

test("no file of the page contains a path of the build machine", async () => {
  const cargo = process.env.CARGO_HOME ?? path.join(homedir(), ".cargo");
  const traces = [ROOT, cargo, `${homedir()}${path.sep}`, process.env.CARGO_TARGET_DIR].filter(Boolean);
  for (const name of await filesOf(DIST)) {
    const bytes = await readFile(path.join(DIST, name));
    for (const trace of traces) assert.equal(bytes.indexOf(trace), -1, `${name} has ${trace}`);
  }
});

test("a local build can be compared with the published page", async ({ server }) => {
  const compared = () => run("node", [COMPARE, server.url, DIST]).then(({ stdout }) => stdout, ({ stdout }) => stdout);
  assert.match(await compared(), /all \d+ files are identical/);
  const worker = String(await readFile(path.join(DIST, "js/worker/vision-worker.js")));
  server.intercept((name, response) => name === "js/worker/vision-worker.js" && Boolean(response.end(`${worker}\n`)));
  assert.match(await compared(), /✗ js\/worker\/vision-worker\.js/);
});

/** Sorted file names in the folder and its subfolders. @param {string} folder */
async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile() && entry.name !== ".trunk-lock");
  return files.map((entry) => path.relative(folder, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/")).sort();
}

/** @param {string | Uint8Array} bytes */
function integrity(bytes) {
  return `sha256-${createHash("sha256").update(bytes).digest("base64")}`;
}
