import { asTrouble, hideNotice, showTrouble } from "../page/notice.js";
import { studioModule } from "./studio-module.js";

/** @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio */

/** A browser may take this long to give a WebGL2 context back before the visitor is told. */
const PATIENCE_MS = 4000;

/**
 * Gets a GPU back that was lost to a driver's reset or to another page. Nothing of the user's is on it alone: the studio
 * goes on with the next one where it stopped.
 */
export class GpuKeeper {
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
    this.#watch();
  }

  /** Whether there is anything to draw with. */
  get isThere() {
    return this.#isThere;
  }

  /** WebGPU gives another device at once. */
  async #watch() {
    await this.#studio.gpuLost();
    this.#lose();
    await this.#replace();
  }

  #lose() {
    this.#isThere = false;
    this.#patience = setTimeout(() => this.#tell("it was not given back"), PATIENCE_MS);
  }

  async #replace() {
    try {
      this.#studio.useRenderer(await studioModule().createRenderer(this.#canvas));
      this.#isThere = true;
      this.#watch();
      this.#whenBack();
      hideNotice();
    } catch (error) {
      this.#tell(asTrouble(error).message);
    } finally {
      clearTimeout(this.#patience);
    }
  }

  /** @param {string} message */
  #tell(message) {
    showTrouble({ code: "device-lost", message, hint: "" });
  }
}
