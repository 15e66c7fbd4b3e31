import { asPageError } from "../page/page-error.js";
import { studioModule } from "./studio-module.js";

/** @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio */

/**
 * @typedef {object} Around
 * @property {() => void} whenBack
 * @property {import("./workbench.js").Notices} notices
 * @property {AbortSignal} gone when nothing is to be drawn any more
 */

/** A browser may take this long to give a WebGL2 context back before the visitor is told. */
const PATIENCE_MS = 4000;

/**
 * Gets a GPU back that was lost to a driver's reset or to another page. Nothing of the user's is on it alone: the studio
 * goes on with the next one where it stopped.
 */
export class DeviceLossHandler {
  #isThere = true;
  #patience = 0;
  #canvas;
  #studio;
  #around;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Studio} studio
   * @param {Around} around
   */
  constructor(canvas, studio, around) {
    this.#canvas = canvas;
    this.#studio = studio;
    this.#around = around;
    const { gone: signal } = around;
    signal.addEventListener("abort", () => clearTimeout(this.#patience));
    canvas.addEventListener("webglcontextlost", (event) => {
      // The browser gives a context back only to those who ask for it so.
      event.preventDefault();
      this.#lose();
    }, { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#replace(), { signal });
    this.watch(studio);
  }

  /** Whether there is anything to draw with. */
  get isThere() {
    return this.#isThere;
  }

  /**
   * Sees to the GPU of this studio, and no longer to that of another. WebGPU gives another device at once.
   *
   * @param {Studio} studio
   */
  async watch(studio) {
    this.#studio = studio;
    this.#found();
    await studio.gpuLost();
    if (this.#isReplaced(studio)) return;
    this.#lose();
    await this.#replace();
  }

  #lose() {
    this.#isThere = false;
    clearTimeout(this.#patience);
    this.#patience = setTimeout(() => this.#tell("it was not given back"), PATIENCE_MS);
  }

  #found() {
    this.#isThere = true;
    clearTimeout(this.#patience);
  }

  async #replace() {
    const studio = this.#studio;
    try {
      const renderer = await studioModule().createRenderer(this.#canvas);
      if (this.#isReplaced(studio)) return renderer.free();
      studio.useRenderer(renderer);
      this.watch(studio);
      this.#around.whenBack();
      this.#around.notices.hide();
    } catch (error) {
      if (!this.#isReplaced(studio)) this.#tell(asPageError(error).message);
    }
  }

  /** @param {Studio} studio which may not be touched any more, then */
  #isReplaced(studio) {
    return studio !== this.#studio || this.#around.gone.aborted;
  }

  /** @param {string} message */
  #tell(message) {
    clearTimeout(this.#patience);
    this.#around.notices.show({ code: "device-lost", message, hint: "" });
  }
}
