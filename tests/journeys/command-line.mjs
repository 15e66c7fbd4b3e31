import { execFile } from "node:child_process";
import { existsSync, statSync } from "node:fs";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { promisify } from "node:util";

const ROOT = path.resolve(import.meta.dirname, "../..");
const TARGET = process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target");

/**
 * The mesh that the command line makes of a photo, as JSON.
 *
 * @param {string} photo
 * @param {string[]} options of `rosto mesh`
 */
export async function meshByCommandLine(photo, options) {
  return JSON.parse((await fileByCommandLine("mesh", photo, "json", options)).toString());
}

/**
 * A GLB that the command line makes of a photo.
 *
 * @param {string} photo
 * @param {string[]} options of `rosto mesh`
 */
export function glbByCommandLine(photo, options) {
  return fileByCommandLine("mesh", photo, "glb", options);
}

/**
 * The photo that the command line makes of a photo, as a PNG.
 *
 * @param {string} photo
 * @param {string[]} options of `rosto photo`
 */
export function photoByCommandLine(photo, options) {
  return fileByCommandLine("photo", photo, "png", options);
}

/**
 * @param {"mesh" | "photo"} task
 * @param {string} photo
 * @param {string} ending
 * @param {string[]} options
 */
async function fileByCommandLine(task, photo, ending, options) {
  const folder = await mkdtemp(path.join(tmpdir(), "rosto-"));
  try {
    const file = path.join(folder, `made.${ending}`);
    await promisify(execFile)(program(), [task, photo, "-o", file, ...options]);
    return await readFile(file);
  } finally {
    await rm(folder, { recursive: true });
  }
}

/**
 * What `rosto paper` finds about each operator and constraint on a photo.
 *
 * @param {string} photo
 * @param {string[]} options
 */
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
