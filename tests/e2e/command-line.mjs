import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync, statSync } from "node:fs";
import { mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";

const ROOT = path.resolve(import.meta.dirname, "../..");
const TARGET = process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target");

/** The page's default edit options, as options of `rosto mesh`. */
export const PAGE_EDIT_OPTIONS = "--units mm --topology canonical --operator cotangent --constraint exact --anchors oval --radius 25 --mirror".split(" ");

/**
 * The command line's mesh of a photo, as JSON.
 *
 * @param {string} photo
 * @param {string[]} options options of `rosto mesh`
 */
export async function meshByCommandLine(photo, options) {
  return JSON.parse((await fileByCommandLine("mesh", photo, "made.json", options)).toString());
}

/** The command line's GLB of a photo. @param {string} photo @param {string[]} options options of `rosto mesh` */
export function glbByCommandLine(photo, options) {
  return fileByCommandLine("mesh", photo, "made.glb", options);
}

/** The command line's edited photo, as PNG. @param {string} photo @param {string[]} options options of `rosto photo` */
export function photoByCommandLine(photo, options) {
  return fileByCommandLine("photo", photo, "made.png", options);
}

/** Results of `rosto paper` for each operator and constraint. @param {string} photo @param {string[]} options */
export async function paperByCommandLine(photo, options) {
  const { code, stdout, log } = await run("paper", photo, ".", options);
  assert.equal(code, 0, log);
  const rows = stdout.slice(stdout.indexOf("| Operator")).trim().split("\n").slice(2);
  return rows.map((row) => {
    const [operator, hold, , ...measures] = row.split("|").slice(1).map((cell) => cell.trim());
    const [bent, stretch, flipped, smooth] = measures.map(Number.parseFloat);
    return { operator, hold, bent, stretch, flipped, smooth };
  });
}

/** Files that `rosto mesh` writes, by name, and its output. There are no files if it fails. */
export function filesByCommandLine(photo, name, options) {
  return run("mesh", photo, name, options);
}

/** @param {"mesh" | "photo"} task @param {string} photo @param {string} name @param {string[]} options */
async function fileByCommandLine(task, photo, name, options) {
  const { files, code, log } = await run(task, photo, name, options);
  assert.equal(code, 0, log);
  return files.get(name);
}

/**
 * Runs the command line in a temporary folder.
 *
 * @param {string} task
 * @param {string} photo
 * @param {string} output
 * @param {string[]} options
 */
async function run(task, photo, output, options) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-"));
  const running = promisify(execFile)(program(), [task, photo, "-o", path.join(folder, output), ...options]);
  const { stdout, stderr, code = 0 } = await running.catch((refused) => refused);
  const files = (await readdir(folder)).map(async (name) => /** @type {const} */ ([name, await readFile(path.join(folder, name))]));
  const made = { files: new Map(await Promise.all(files)), stdout, log: `${stdout}${stderr}`, code };
  await rm(folder, { recursive: true });
  return made;
}

/** Path of the command line: from ROSTO_CLI, or the newest build. */
export function program() {
  const built = ["release", "debug"].map((profile) => path.join(TARGET, profile, "rosto")).filter((file) => existsSync(file));
  const [found] = process.env.ROSTO_CLI ? [process.env.ROSTO_CLI] : built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs);
  if (!found) throw new Error("`rosto` not found: build it, or set ROSTO_CLI");
  return found;
}
