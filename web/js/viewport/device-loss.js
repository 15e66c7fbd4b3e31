import { asPageError } from "../page/page-error.js";
import { disown, studioModule } from "./studio-module.js";

/** @typedef {import("./host.js").Host} Host */

/** A browser may take this long to give a WebGL2 context back before the visitor is told. */
const PATIENCE_MS = 4000;

/**
 * Gets a GPU back that was lost to a driver's reset or to another page. Nothing of the user's is on it alone: the studio
 * goes on with the next one where it stopped.
 */
export class DeviceLossHandler {
  #isThere = true;
  #patience = 0;
  #host;
  #notices;

  /**
   * @param {Host} host
   * @param {import("./host.js").Notices} notices
   */
  constructor(host, notices) {
    this.#host = host;
    this.#notices = notices;
    const { canvas, gone: signal } = host;
    signal.addEventListener("abort", () => clearTimeout(this.#patience));
    canvas.addEventListener("webglcontextlost", (event) => {
      // The browser gives a context back only to those who ask for it so.
      event.preventDefault();
      this.#lose();
    }, { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#replace(), { signal });
    this.watch();
  }

  /** Whether there is anything to draw with. */
  get isThere() {
    return this.#isThere;
  }

  /** Sees to the GPU of the host's studio, and no longer to that of the one before. WebGPU gives another device at once. */
  async watch() {
    const { life } = this.#host;
    this.#found();
    await this.#host.ask((studio) => studio.gpuLost());
    if (this.#isReplaced(life)) return;
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
    const { life, canvas } = this.#host;
    try {
      const renderer = await studioModule().createRenderer(canvas);
      if (this.#isReplaced(life)) return this.#host.life === life ? renderer.free() : disown(renderer);
      this.#host.answer((studio) => studio.useRenderer(renderer));
      this.watch();
      this.#host.requestFrame();
      this.#notices.hide("gpu");
    } catch (error) {
      if (!this.#isReplaced(life)) this.#tell(asPageError(error).message);
    }
  }

  /** @param {object} life of the studio whose GPU was lost: it may not be touched any more, then */
  #isReplaced(life) {
    return life !== this.#host.life || this.#host.gone.aborted;
  }

  /** @param {string} message */
  #tell(message) {
    clearTimeout(this.#patience);
    this.#notices.show({ code: "device-lost", message, hint: "" }, "gpu");
  }
}
