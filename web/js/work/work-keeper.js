import { byId } from "../page/dom.js";
import { keepEdits, keepFace, keptWork } from "./kept-work.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 */

/** Edits are kept this long after the last of them. */
const PAUSE_MS = 300;

/** Keeps the work in this browser, so that a reload or a crash loses nothing, and offers it on the next visit. */
export class WorkKeeper {
  /** @type {OpenedFace | undefined} */
  #face;
  /** @type {Workbench | undefined} */
  #bench;
  #edits = "";
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
    this.#edits = this.#bench?.studio.editsJson() ?? "";
    // A browser that keeps nothing, such as a private window, is no reason to stop working.
    keepFace(face, this.#edits).catch(() => {});
  }

  /** The work as it stands. */
  get work() {
    if (!this.#face || !this.#bench) return undefined;
    return { face: this.#face, edits: this.#bench.studio.editsJson() };
  }

  #keepEdits() {
    const edits = this.#bench?.studio.editsJson() ?? "";
    if (edits === this.#edits) return;
    this.#edits = edits;
    keepEdits(edits).catch(() => {});
  }
}
