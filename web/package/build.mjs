// Builds the npm package from the built page: node web/package/build.mjs [FOLDER]. The folder defaults to
// target/npm/rosto. The package contains the modules reachable from its entry points, and the type declarations
// reachable from theirs.
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
/** Static and dynamic imports, and URLs of workers. */
const IMPORT = /(?:from |import\(|import |new URL\()"(\.[^"]+\.js)"/g;

const manifest = JSON.parse(await text(path.join(import.meta.dirname, "package.json")));
const entries = Object.values(manifest.exports).map((entry) => entry.default).filter(Boolean).map(path.normalize);

await Promise.all([OUT, TYPES].map((folder) => rm(folder, { recursive: true, force: true })));
const scripts = await reachable(entries, async (name) => (await text(sourceFile(name))).replace(COMMENT, ""));
for (const name of scripts) await copy(sourceFile(name), name);
for (const name of scripts.filter((name) => name.startsWith("wasm/"))) {
  await copy(path.join(DIST, name.replace(/\.js$/, "_bg.wasm")), name.replace(/\.js$/, "_bg.wasm"));
}
for (const name of [...NETWORKS, "words"]) await copy(path.join(ROOT, "web", name), name);

await emitDeclarations();
const declarations = await reachable(entries, (name) => text(typeFile(name)));
for (const name of declarations) await copy(typeFile(name), declarationName(name));
await copy(path.join(import.meta.dirname, "element.d.ts"), "element.d.ts");
await rm(TYPES, { recursive: true });

for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "NOTICE"]) await copy(path.join(ROOT, name), name);
await copy(path.join(import.meta.dirname, "README.md"), "README.md");
const version = /^version = "(.+)"$/m.exec(await text(path.join(ROOT, "Cargo.toml")))?.[1];
await writeFile(path.join(OUT, "package.json"), `${JSON.stringify({ ...manifest, version }, undefined, 2)}\n`);
console.log(`${path.relative(ROOT, OUT)}: ${scripts.length} modules, ${declarations.length} declarations`);

/**
 * The modules reachable from `names`, including these.
 *
 * @param {string[]} names
 * @param {(name: string) => Promise<string>} read
 */
async function reachable(names, read) {
  const all = new Set(names);
  for (const name of all) {
    for (const [, other] of (await read(name)).matchAll(IMPORT)) all.add(path.join(path.dirname(name), other));
  }
  return [...all].sort();
}

/** Source of a module: handwritten, or generated in the build. @param {string} name */
function sourceFile(name) {
  return path.join(name.startsWith("wasm/") ? DIST : path.join(ROOT, "web"), name);
}

/** Generates declarations of the handwritten modules with tsc. */
async function emitDeclarations() {
  const options = ["--declaration", "--emitDeclarationOnly", "--noEmit", "false", "--rootDir", "web", "--outDir", TYPES];
  await promisify(execFile)("npx", ["tsc", "--project", "tsconfig.json", ...options], { cwd: ROOT });
}

/** @param {string} name of a module */
function typeFile(name) {
  return path.join(name.startsWith("wasm/") ? DIST : TYPES, declarationName(name));
}

/** @param {string} name of a module */
function declarationName(name) {
  return name.replace(/\.js$/, ".d.ts");
}

/** @param {string} from @param {string} name in the package */
async function copy(from, name) {
  await mkdir(path.dirname(path.join(OUT, name)), { recursive: true });
  await cp(from, path.join(OUT, name), { recursive: true });
}

/** @param {string} file */
async function text(file) {
  return String(await readFile(file));
}
