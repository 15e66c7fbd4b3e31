// Puts the npm package together out of the built page: node web/package/build.mjs. It comes to lie in target/npm/rosto.
// Of the page's modules it has those that its own ones reach, and of their types those that these name.
import { execFile } from "node:child_process";
import { cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";

const ROOT = path.resolve(import.meta.dirname, "../..");
const DIST = path.resolve(process.env.ROSTO_DIST ?? path.join(ROOT, "dist"));
const OUT = path.resolve(process.argv[2] ?? path.join(ROOT, "target/npm/rosto"));
const TYPES = `${OUT}-types`;

const NETWORKS = ["assets/face_detector.onnx", "assets/face_landmarks_attention.onnx"];

const COMMENT = /\/\*\*[\s\S]*?\*\/|^\s*\/\/.*$/gm;
/** A module that is imported, now or later, and a worker that is started. */
const NAMED = /(?:from |import\(|import |new URL\()"(\.[^"]+\.js)"/g;

const manifest = JSON.parse(await text(path.join(import.meta.dirname, "package.json")));
const entries = Object.values(manifest.exports).map((entry) => entry.default).filter(Boolean).map(path.normalize);

await Promise.all([OUT, TYPES].map((folder) => rm(folder, { recursive: true, force: true })));
const scripts = await reached(entries, async (name) => (await text(sourceOf(name))).replace(COMMENT, ""));
for (const name of scripts) await put(sourceOf(name), name);
for (const name of scripts.filter((name) => name.startsWith("wasm/"))) {
  await put(path.join(DIST, name.replace(/\.js$/, "_bg.wasm")), name.replace(/\.js$/, "_bg.wasm"));
}
for (const name of [...NETWORKS, "words"]) await put(path.join(ROOT, "web", name), name);

await declare();
const declarations = await reached(entries, (name) => text(typeOf(name)));
for (const name of declarations) await put(typeOf(name), declared(name));
await put(path.join(import.meta.dirname, "element.d.ts"), "element.d.ts");
await rm(TYPES, { recursive: true });

for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "NOTICE"]) await put(path.join(ROOT, name), name);
await put(path.join(import.meta.dirname, "README.md"), "README.md");
const version = /^version = "(.+)"$/m.exec(await text(path.join(ROOT, "Cargo.toml")))?.[1];
await writeFile(path.join(OUT, "package.json"), `${JSON.stringify({ ...manifest, version }, undefined, 2)}\n`);
console.log(`${path.relative(ROOT, OUT)}: ${scripts.length} modules, ${declarations.length} with types`);

/**
 * The modules that some reach, themselves among them.
 *
 * @param {string[]} names
 * @param {(name: string) => Promise<string>} read
 */
async function reached(names, read) {
  const all = new Set(names);
  for (const name of all) {
    for (const [, other] of (await read(name)).matchAll(NAMED)) all.add(path.join(path.dirname(name), other));
  }
  return [...all].sort();
}

/** Where a module of the package is from: what is written by hand, or what was built. @param {string} name */
function sourceOf(name) {
  return path.join(name.startsWith("wasm/") ? DIST : path.join(ROOT, "web"), name);
}

/** Has tsc tell the types of all modules that are written by hand. */
async function declare() {
  const options = ["--declaration", "--emitDeclarationOnly", "--noEmit", "false", "--rootDir", "web", "--outDir", TYPES];
  await promisify(execFile)("npx", ["tsc", "--project", "tsconfig.json", ...options], { cwd: ROOT });
}

/** @param {string} name of a module */
function typeOf(name) {
  return path.join(name.startsWith("wasm/") ? DIST : TYPES, declared(name));
}

/** @param {string} name of a module */
function declared(name) {
  return name.replace(/\.js$/, ".d.ts");
}

/** @param {string} from @param {string} name in the package */
async function put(from, name) {
  await mkdir(path.dirname(path.join(OUT, name)), { recursive: true });
  await cp(from, path.join(OUT, name), { recursive: true });
}

/** @param {string} file */
async function text(file) {
  return String(await readFile(file));
}
