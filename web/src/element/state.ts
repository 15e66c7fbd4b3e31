import type { FaceSession } from "./face-session.ts";

/** The state of an element. */
export interface StudioSnapshot {
  /** to show a face */
  ready: boolean;
  /** in the photo; 0 before a face is shown */
  faces: number;
  /** of the displayed mesh */
  vertices: number;
  /** in the history */
  edits: number;
  canUndo: boolean;
  canRedo: boolean;
  /** landmark or vertex */
  selected: number | undefined;
  shading: string | undefined;
  density: string | undefined;
  lens: string | undefined;
  /** value of each slider */
  sliders_mm: Record<string, number>;
}

const CLOSED: StudioSnapshot = {
  ...{ ready: false, faces: 0, vertices: 0, edits: 0, canUndo: false, canRedo: false, selected: undefined },
  ...{ shading: undefined, density: undefined, lens: undefined, sliders_mm: {} },
};

export function stateOf(session: FaceSession | undefined): StudioSnapshot {
  const state = session?.host.read(({ vertexCount, entryCount, canUndo, canRedo, selected, chosen, slidersMm }) => ({
    ...{ ready: true, faces: session.faces.length, vertices: vertexCount, edits: entryCount },
    ...{ canUndo, canRedo, selected, sliders_mm: slidersMm },
    ...{ shading: chosen["shading"], density: chosen["density"], lens: chosen["lens"] },
  }));
  return state ?? CLOSED;
}

/** The colour scheme that the element inherits from the page. */
export function themeOf(element: HTMLElement) {
  const scheme = getComputedStyle(element).colorScheme;
  const isDark = scheme.includes("dark") && (!scheme.includes("light") || matchMedia("(prefers-color-scheme: dark)").matches);
  return isDark ? "dark" : "light";
}
