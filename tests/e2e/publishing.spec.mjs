import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { appendFile, copyFile, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { homedir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";
import { test } from "./fixtures.mjs";
import { release, UNNAMED } from "../../web/build/release.mjs";
import { DIST, inVersion, versionIn } from "./server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const COMPARE = path.join(ROOT, "web/build/compare.mjs");
const run = promisify(execFile);

const IMMUTABLE = "public, max-age=31536000, immutable";

test("the page is served with its security headers, and all host configurations list the same ones", { tag: "@usual" }, async ({ visitor }) => {
  const policy = await visitor.page.getAttribute("meta[http-equiv='Content-Security-Policy']", "content");
  for (const name of ["./", "service-worker.js", await inVersion("vision-worker.js"), await inVersion("rosto-vision-web_bg.wasm")]) {
    const headers = await visitor.page.evaluate(async (name) => Object.fromEntries((await fetch(name)).headers), name);
    assert.equal(headers["content-security-policy"], `${policy}; frame-ancestors 'none'`);
    assert.equal(headers["cross-origin-opener-policy"], "same-origin");
    assert.equal(headers["x-content-type-options"], "nosniff");
    assert.equal(headers["referrer-policy"], "no-referrer");
    assert.equal(headers["cache-control"], name.includes("/", 2) ? IMMUTABLE : "no-cache");
    assert.equal(headers["permissions-policy"], "camera=(self), microphone=(), geolocation=(), display-capture=(), fullscreen=()");
  }

  const headersIn = async (name, pattern) => [...String(await readFile(path.join(DIST, name))).matchAll(pattern)].map(([, name, value]) => [name, value]);
  const plain = (await headersIn("_headers", /^ {2}([\w-]+): (.*)$/gm)).filter(([name]) => name !== "Cache-Control");
  assert.equal(plain.length, 5);
  const revalidated = [...plain, ["Cache-Control", "no-cache"]];
  assert.deepEqual((await headersIn(".htaccess", /^ {2}Header always set ([\w-]+) "(.*?)"/gm)), [...revalidated, ["Cache-Control", IMMUTABLE]]);
  assert.deepEqual(await headersIn("nginx.conf", /^add_header ([\w-]+) "(.*)" always;$/gm), plain);
  assert.match(String(await readFile(path.join(DIST, "nginx.conf"))), /"no-cache"[\s\S]*immutable/);
  const { headers } = JSON.parse(String(await readFile(path.join(DIST, "vercel.json"))));
  assert.deepEqual(headers.map(({ headers }) => headers.map(({ key, value }) => [key, value])), [revalidated, [["Cache-Control", IMMUTABLE]]]);
});

test("other pages cannot frame the page", { tag: "@usual" }, async ({ page }) => {
  const another = await page.context().newPage();
  await another.setContent(`<iframe src="${page.url()}"></iframe>`);
  const frame = await (await another.waitForSelector("iframe")).contentFrame();
  await frame.waitForLoadState();
  assert.equal(await frame.locator("#stage").count(), 0);
});

test("the service worker lists the SHA-256 of each file of the version, and the page those of its scripts", { tag: "@usual" }, async () => {
  const version = await versionIn(DIST);
  const page = String(await readFile(path.join(DIST, "index.html")));
  const worker = String(await readFile(path.join(DIST, "service-worker.js")));
  assert.ok(worker.includes(version));
  for (const name of await filesOf(path.join(DIST, version))) {
    const hash = `sha256-${createHash("sha256").update(await readFile(path.join(DIST, version, name))).digest("base64")}`;
    assert.ok(worker.includes(`"${name}":"${hash}"`) || worker.includes(`${name}:"${hash}"`), name);
    if (/^(page|start)\.(js|css)$/.test(name)) assert.ok(page.includes(`="${version}/${name}" integrity="${hash}"`), name);
  }
});

test("the order of files does not change the name of a version, but a changed file does", { tag: "@usual" }, async () => {
  const version = await versionIn(DIST);
  const folder = test.info().outputPath("dist");
  const copy = async () => {
    await rm(folder, { recursive: true, force: true });
    for (const name of (await filesOf(DIST)).reverse()) {
      const place = path.join(folder, name.replace(version, UNNAMED));
      await mkdir(path.dirname(place), { recursive: true });
      await copyFile(path.join(DIST, name), place);
    }
    const page = path.join(folder, "index.html");
    await writeFile(page, String(await readFile(page)).replaceAll(`${version}/`, `${UNNAMED}/`));
  };
  await copy();
  await release(folder);
  for (const name of await filesOf(DIST)) {
    assert.ok((await readFile(path.join(folder, name))).equals(await readFile(path.join(DIST, name))), name);
  }
  await copy();
  await appendFile(path.join(folder, UNNAMED, "rosto.svg"), " ");
  await release(folder);
  assert.notEqual(await versionIn(folder), version);
});

test("no file of the page contains a path of the build machine", { tag: "@usual" }, async () => {
  const cargo = process.env.CARGO_HOME ?? path.join(homedir(), ".cargo");
  const traces = [ROOT, cargo, `${homedir()}${path.sep}`, process.env.CARGO_TARGET_DIR].filter(Boolean);
  for (const name of await filesOf(DIST)) {
    const bytes = await readFile(path.join(DIST, name));
    for (const trace of traces) assert.equal(bytes.indexOf(trace), -1, `${name} has ${trace}`);
  }
});

test("a local build can be compared with the published page", { tag: "@usual" }, async ({ server }) => {
  const compared = () => run("node", [COMPARE, server.url, DIST]).then(({ stdout }) => stdout, ({ stdout }) => stdout);
  assert.match(await compared(), /all \d+ files are identical/);
  const name = await inVersion("vision-worker.js");
  const worker = String(await readFile(path.join(DIST, name)));
  server.intercept((asked, response) => asked === name && Boolean(response.end(`${worker}\n`)));
  assert.match(await compared(), /✗ [0-9a-f]{16}\/vision-worker\.js/);
});

/** Sorted file names in the folder and its subfolders. @param {string} folder */
async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile() && entry.name !== ".trunk-lock");
  return files.map((entry) => path.relative(folder, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/")).sort();
}
