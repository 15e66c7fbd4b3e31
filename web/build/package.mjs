// Builds the npm package from the built page: node web/build/package.mjs [FOLDER]. The folder defaults to
// target/npm/rosto.
import { execFile } from "node:child_process";
import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { build } from "esbuild";
import { MODULES, WEB, WORKER } from "./scripts.mjs";

const ROOT = path.dirname(WEB);
const DIST = path.resolve(process.env.ROSTO_DIST ?? path.join(ROOT, "dist"));
const OUT = path.resolve(process.argv[2] ?? path.join(ROOT, "target/npm/rosto"));

await rm(OUT, { recursive: true, force: true });
await mkdir(OUT, { recursive: true });
await build({ ...MODULES, entryPoints: { rosto: "src/package.ts" }, outdir: OUT });
await build({ ...WORKER, outdir: OUT });
const version = (await readdir(DIST)).find((name) => /^[0-9a-f]{16}$/.test(name)) ?? "";
for (const name of await readdir(path.join(DIST, version))) {
  if (/\.(wasm|onnx)$|^icons\.svg$/.test(name)) await cp(path.join(DIST, version, name), path.join(OUT, name));
}
await writeTypes();
for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "NOTICE", "web/package/README.md"]) await cp(path.join(ROOT, name), path.join(OUT, path.basename(name)));
const manifest = JSON.parse(String(await readFile(path.join(WEB, "package/package.json"))));
const [, released] = /^version = "(.+)"$/m.exec(String(await readFile(path.join(ROOT, "Cargo.toml")))) ?? [];
await writeFile(path.join(OUT, "package.json"), `${JSON.stringify({ ...manifest, version: released }, undefined, 2)}\n`);
console.log(`${path.relative(ROOT, OUT)}: ${(await readdir(OUT)).length} files`);

/** Writes the declarations of the sources and of the modules. */
async function writeTypes() {
  const types = path.join(OUT, "types");
  const options = ["--declaration", "--emitDeclarationOnly", "--noEmit", "false", "--rootDir", "web", "--outDir", types];
  await promisify(execFile)("npx", ["tsc", "--project", "tsconfig.json", ...options], { cwd: ROOT });
  await cp(path.join(WEB, "wasm"), path.join(types, "wasm"), { recursive: true, filter: (name) => !name.endsWith(".js") });
  for (const name of await readdir(types, { recursive: true })) {
    if (!name.endsWith(".d.ts")) continue;
    const file = path.join(types, name);
    const declared = String(await readFile(file)).replaceAll(/(from "[^"]+|import\("[^"]+)\.ts"/g, '$1.js"');
    // The package has no words files.
    await writeFile(file, declared.replaceAll(/keyof typeof import\("[^"]+\.json"\)/g, "string"));
  }
}
