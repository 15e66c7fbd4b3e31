/** @typedef {{ name: string, needs: "gpu" | "eyes" | "webgl" | "no-gpu" | "camera" | "moving-camera" | "seen-camera" | "way-back", walk: (open: (options?: object) => Promise<import("./visitor.mjs").Visitor>) => Promise<void> }} Journey */

/** @type {Journey[]} */
export const journeys = [];

/**
 * A way through the page, as a visitor goes it.
 *
 * @param {string} name what holds at its end
 * @param {Journey["walk"]} walk opens the page as often as it likes; under another `url` if it has a server of its own
 * @param {{ needs?: Journey["needs"] }} [options] the browser it needs; `eyes`: one whose screenshots
 *   show the 3D view; `moving-camera`: its camera plays the film of film-frames.mjs; `seen-camera`: both; `way-back`: it keeps
 *   pages that are left for the way back
 */
export function journey(name, walk, { needs = "gpu" } = {}) {
  journeys.push({ name, needs, walk });
}
