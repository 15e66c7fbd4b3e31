import { byId } from "../page/dom.js";
import { chosenDensity, chosenTriangulation } from "../panel/view-panel.js";
import { keepEdits, keepFace, keptWork } from "./kept-work.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 */

/** Faces and edits are kept this long after the last change. */
const PAUSE_MS = 300;

/** Keeps the work in this browser, so that a reload or a crash loses nothing, and offers it on the next visit. */
export class WorkKeeper {
  /** @type {OpenedFace | undefined} */
  #face;
  /** @type {Workbench | undefined} */
  #bench;
  #kept = "";
  #pause = 0;

  /**
   * Offers the work of the last visit.
   *
   * @param {(work: Work) => void} open
   */
  async offer(open) {
    const button = byId("continue", HTMLButtonElement);
    const work = await keptWork().catch(() => undefined);
    if (!work || this.#face) return;
    button.hidden = false;
    button.addEventListener("click", () => open(work), { once: true });
  }

  /** @param {Workbench} bench */
  follow(bench) {
    this.#bench = bench;
    bench.onChange((state) => {
      if (!this.#face || state.editing) return;
      clearTimeout(this.#pause);
      this.#pause = setTimeout(() => this.#keepEdits(), PAUSE_MS);
    });
  }

  /**
   * Takes charge of a face that has just been opened.
   *
   * @param {OpenedFace} face
   */
  take(face) {
    this.#face = face;
    const { work } = this;
    if (!work) return;
    const { edits, triangulation, density } = work;
    this.#kept = JSON.stringify([edits, triangulation, density]);
    // Not in the task that brings the face to the screen; and a browser that keeps nothing is no reason to stop working.
    setTimeout(() => keepFace(face, { edits, triangulation, density }).catch(() => {}), PAUSE_MS);
  }

  /** The work as it stands. */
  get work() {
    if (!this.#face || !this.#bench) return undefined;
    const edits = this.#bench.studio.editsJson();
    return { face: this.#face, edits, triangulation: chosenTriangulation(), density: chosenDensity() };
  }

  #keepEdits() {
    const { work } = this;
    if (!work) return;
    const { edits, triangulation, density } = work;
    const now = JSON.stringify([edits, triangulation, density]);
    if (now === this.#kept) return;
    this.#kept = now;
    keepEdits({ edits, triangulation, density }).catch(() => {});
  }
}
