// Runs at the end of a Trunk build: tells the service worker which files there are, and gives the set a version.
import { createHash } from "node:crypto";
import { readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";

const PLACEHOLDER = '{ version: "unbuilt", files: [], fallback: [] }';
/** What only browsers without WebGPU download. */
const FALLBACK = /^wasm\/rosto-studio-webgl/;

const dist = process.env.TRUNK_STAGING_DIR ?? "dist";
const serviceWorker = path.join(dist, "service-worker.js");

const files = (await readdir(dist, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/"))
  .filter((file) => !file.endsWith(".d.ts") && file !== "service-worker.js")
  .sort();

const hash = createHash("sha256");
for (const file of files) hash.update(file).update(await readFile(path.join(dist, file)));
const version = hash.digest("hex").slice(0, 16);

// The page itself is asked for as "./".
const everyones = files.filter((file) => !FALLBACK.test(file)).map((file) => (file === "index.html" ? "./" : file));
const offline = { version, files: everyones, fallback: files.filter((file) => FALLBACK.test(file)) };
const script = await readFile(serviceWorker, "utf8");
if (!script.includes(PLACEHOLDER)) throw new Error(`${serviceWorker} has no place for the list of files`);
await writeFile(serviceWorker, script.replace(PLACEHOLDER, JSON.stringify(offline)));
