/** @typedef {{ name: string, needs: "gpu" | "eyes" | "webgl" | "no-gpu" | "camera" | "moving-camera" | "seen-camera" | "way-back", walk: (open: (options?: object) => Promise<import("./visitor.mjs").Visitor>) => Promise<void> }} Journey */

/** What a journey has to have in its name to be walked. */
export const WANTED = process.argv.slice(2).filter((word) => !word.startsWith("--")).join(" ");

/** A test run has no time for every journey; `cargo xtask torture` does, and who asks for one by name. */
const WALKS_ALL = process.argv.includes("--all") || WANTED !== "";

/** @type {Journey[]} */
export const journeys = [];

/**
 * A way through the page, as a visitor goes it.
 *
 * @param {string} name what holds at its end
 * @param {Journey["walk"]} walk opens the page as often as it likes; under another `url` if it has a server of its own
 * @param {{ needs?: Journey["needs"], isRare?: boolean }} [options] the browser it needs; `eyes`: one whose screenshots
 *   show the 3D view; `moving-camera`: its camera plays the film of film-frames.mjs; `seen-camera`: both; `way-back`: it keeps
 *   pages that are left for the way back. `isRare`: a test run leaves it out
 */
export function journey(name, walk, { needs = "gpu", isRare = false } = {}) {
  if (WALKS_ALL || !isRare) journeys.push({ name, needs, walk });
}

/**
 * Cases that are much alike, of which a test run takes the first `count`.
 *
 * @template T
 * @param {readonly T[]} cases
 */
export function alike(cases, count = 1) {
  return WALKS_ALL ? cases : cases.slice(0, count);
}
