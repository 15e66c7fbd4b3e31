// Trunk's post-build hook: bundles the page's scripts and styles, and releases the build.
import { cp, mkdir, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";
import { UNNAMED, release } from "./release.mjs";
import { BUNDLES, WEB } from "./scripts.mjs";

const ASSETS = ["assets/face_detector.onnx", "assets/face_landmarks_attention.onnx", "assets/sample.png"];

const dist = process.env.TRUNK_STAGING_DIR ?? "dist";
const folder = path.join(dist, UNNAMED);

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
await takeModules();
for (const options of BUNDLES) await build({ ...options, outdir: folder });
for (const name of [...ASSETS, "manifest.webmanifest"]) await cp(path.join(WEB, name), path.join(folder, path.basename(name)));
await cp(path.join(WEB, "icons"), folder, { recursive: true });
const validator = path.join(WEB, "../node_modules/gltf-validator");
for (const name of ["LICENSE", "NOTICES"]) await cp(path.join(validator, name), path.join(folder, `gltf-validator-${name}.txt`));
await release(dist);

/** Moves the modules into the folder, and their scripts and types to `web/wasm`, from where the sources import them. */
async function takeModules() {
  const built = path.join(dist, "wasm");
  await mkdir(path.join(WEB, "wasm"), { recursive: true });
  for (const name of await readdir(built)) {
    if (name.endsWith(".wasm")) await rename(path.join(built, name), path.join(folder, name));
    else await writeIfChanged(path.join(WEB, "wasm", name), await readFile(path.join(built, name)));
  }
  await rm(built, { recursive: true });
}

/** Keeps the file's time otherwise, because Trunk watches it. @param {string} file @param {Buffer} content */
async function writeIfChanged(file, content) {
  const before = await readFile(file).catch(() => undefined);
  if (!before?.equals(content)) await writeFile(file, content);
}
