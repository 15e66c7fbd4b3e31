import { execFile } from "node:child_process";
import { existsSync, statSync } from "node:fs";
import { mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";

const ROOT = path.resolve(import.meta.dirname, "../..");
const TARGET = process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target");

/** The mesh that the command line makes of a photo, as JSON. @param {string} photo @param {string[]} options of `rosto mesh` */
export async function meshByCommandLine(photo, options) {
  return JSON.parse((await fileByCommandLine("mesh", photo, "json", options)).toString());
}

/** A GLB that the command line makes of a photo. @param {string} photo @param {string[]} options of `rosto mesh` */
export function glbByCommandLine(photo, options) {
  return fileByCommandLine("mesh", photo, "glb", options);
}

/** The photo that the command line makes of a photo, as a PNG. @param {string} photo @param {string[]} options of `rosto photo` */
export function photoByCommandLine(photo, options) {
  return fileByCommandLine("photo", photo, "png", options);
}

/**
 * All files that the command line makes of a photo, by their names, and what it says about them. Where it refuses, there are
 * none.
 *
 * @param {string} photo
 * @param {string} name of the first of them
 * @param {string[]} options of `rosto mesh`
 * @returns {Promise<{ files: Map<string, Buffer>, said: string }>}
 */
export function filesByCommandLine(photo, name, options) {
  return inFolder(async (folder) => {
    const making = promisify(execFile)(program(), ["mesh", photo, "-o", path.join(folder, name), ...options]);
    const { stdout, stderr } = await making.catch((refused) => refused);
    const files = (await readdir(folder)).map(async (file) => /** @type {const} */ ([file, await readFile(path.join(folder, file))]));
    return { files: new Map(await Promise.all(files)), said: `${stdout}${stderr}` };
  });
}

/** @param {"mesh" | "photo"} task @param {string} photo @param {string} ending @param {string[]} options */
function fileByCommandLine(task, photo, ending, options) {
  return inFolder(async (folder) => {
    const file = path.join(folder, `made.${ending}`);
    await promisify(execFile)(program(), [task, photo, "-o", file, ...options]);
    return readFile(file);
  });
}

/**
 * @template T
 * @param {(folder: string) => Promise<T>} work in a folder of its own
 */
async function inFolder(work) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-"));
  try {
    return await work(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** What `rosto paper` finds about each operator and constraint on a photo. @param {string} photo @param {string[]} options */
export async function paperByCommandLine(photo, options) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-"));
  try {
    const { stdout } = await promisify(execFile)(program(), ["paper", photo, "-o", folder, ...options]);
    const rows = stdout.slice(stdout.indexOf("| Operator")).trim().split("\n").slice(2);
    return rows.map((row) => {
      const [operator, hold, , bent, stretch, flipped, smooth] = row.split("|").slice(1).map((cell) => cell.trim());
      const [bentBy, stretchedBy, turned, unpeaked] = [bent, stretch, flipped, smooth].map(Number.parseFloat);
      return { operator, hold, bent: bentBy, stretch: stretchedBy, flipped: turned, smooth: unpeaked };
    });
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** The command line itself: as the environment says, or the newest that was built. */
export function program() {
  const built = ["release", "debug"].map((profile) => path.join(TARGET, profile, "rosto")).filter((file) => existsSync(file));
  const [found] = process.env.ROSTO_CLI ? [process.env.ROSTO_CLI] : built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs);
  if (!found) throw new Error("no `rosto` here: build it, or name it in ROSTO_CLI");
  return found;
}
