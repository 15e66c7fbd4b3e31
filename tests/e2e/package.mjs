import { execFile } from "node:child_process";
import { cp, mkdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { SAMPLE } from "./visitor.mjs";

const run = promisify(execFile);
const ROOT = path.resolve(import.meta.dirname, "../..");
/** Playwright's workers run at the same time. */
const PLACE = path.join(ROOT, "target/npm/e2e", process.env.TEST_PARALLEL_INDEX ?? "0");
const BUILT = path.join(PLACE, "rosto");

/** Folder with the example page, next to the package as installed by npm. */
export const SITE = path.join(PLACE, "site");

/** @type {Promise<void> | undefined} */
let installing;

/** Builds, packs and installs the package into {@link SITE}, once per run. */
export const installed = () => (installing ??= install());

async function install() {
  await run("node", ["web/build/package.mjs", BUILT], { cwd: ROOT });
  await rm(SITE, { recursive: true, force: true });
  await mkdir(SITE, { recursive: true });
  const { stdout: tarball } = await run("npm", ["pack", BUILT, "--silent"], { cwd: SITE });
  await writeFile(path.join(SITE, "package.json"), JSON.stringify({ private: true, type: "module" }));
  await run("npm", ["install", "--offline", "--no-audit", "--no-fund", "--silent", `./${tarball.trim()}`], { cwd: SITE });
  await cp(path.join(ROOT, "docs/examples/element.html"), path.join(SITE, "index.html"));
  await cp(SAMPLE, path.join(SITE, "portrait.png"));
}

/**
 * Output of tsc for a module that uses the installed package.
 *
 * @param {string} name
 * @param {string} text
 * @param {string[]} options
 */
export async function tscOutput(name, text, options) {
  await installed();
  await writeFile(path.join(SITE, name), text);
  const tsc = path.join(ROOT, "node_modules/.bin/tsc");
  return run(tsc, [...options, name], { cwd: SITE }).then(() => "", ({ stdout }) => stdout);
}
