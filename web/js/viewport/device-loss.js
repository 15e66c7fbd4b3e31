import { hideNotice, showError } from "../page/notice.js";
import { asPageError } from "../page/page-error.js";
import { studioModule } from "./studio-module.js";

/** @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio */

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
  #whenBack;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Studio} studio
   * @param {() => void} whenBack
   */
  constructor(canvas, studio, whenBack) {
    this.#canvas = canvas;
    this.#studio = studio;
    this.#whenBack = whenBack;
    canvas.addEventListener("webglcontextlost", (event) => {
      // The browser gives a context back only to those who ask for it so.
      event.preventDefault();
      this.#lose();
    });
    canvas.addEventListener("webglcontextrestored", () => this.#replace());
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
    if (studio !== this.#studio) return;
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
      if (studio !== this.#studio) return;
      studio.useRenderer(renderer);
      this.watch(studio);
      this.#whenBack();
      hideNotice();
    } catch (error) {
      if (studio === this.#studio) this.#tell(asPageError(error).message);
    }
  }

  /** @param {string} message */
  #tell(message) {
    clearTimeout(this.#patience);
    showError({ code: "device-lost", message, hint: "" });
  }
}
