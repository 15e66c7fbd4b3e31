/**
 * The state of an element.
 *
 * @typedef {object} StudioSnapshot
 * @property {boolean} ready to show a face
 * @property {number} faces in the photo; 0 before a face is shown
 * @property {number} vertices of the displayed mesh
 * @property {number} edits in the history
 * @property {boolean} canUndo
 * @property {boolean} canRedo
 * @property {number | undefined} selected landmark or vertex
 * @property {string | undefined} shading
 * @property {string | undefined} density
 * @property {string | undefined} lens
 * @property {Record<string, number>} sliders_mm value of each slider
 */

/** @type {StudioSnapshot} */
const CLOSED = {
  ...{ ready: false, faces: 0, vertices: 0, edits: 0, canUndo: false, canRedo: false, selected: undefined },
  ...{ shading: undefined, density: undefined, lens: undefined, sliders_mm: {} },
};

/**
 * @param {import("./face-session.js").FaceSession | undefined} session
 * @returns {StudioSnapshot}
 */
export function stateOf(session) {
  const state = session?.host.read(({ vertexCount, entryCount, canUndo, canRedo, selected, chosen, slidersMm }) => ({
    ...{ ready: true, faces: session.faces.length, vertices: vertexCount, edits: entryCount },
    ...{ canUndo, canRedo, selected, sliders_mm: slidersMm },
    ...{ shading: chosen["shading"], density: chosen["density"], lens: chosen["lens"] },
  }));
  return state ?? CLOSED;
}

/**
 * The colour scheme that the element inherits from the page.
 *
 * @param {HTMLElement} element
 */
export function themeOf(element) {
  const scheme = getComputedStyle(element).colorScheme;
  const isDark = scheme.includes("dark") && (!scheme.includes("light") || matchMedia("(prefers-color-scheme: dark)").matches);
  return isDark ? "dark" : "light";
}
