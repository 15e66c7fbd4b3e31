import { asPageError } from "../page/page-error.ts";
import { studioModule } from "../studio-module.ts";
import type { Host, Notices } from "./host.ts";

/** Time to wait for the browser to restore a WebGL2 context before a notice appears. */
const RESTORE_TIMEOUT_MS = 4000;

/**
 * Recovers from a lost GPU, for example after a driver reset. The session is in memory, so a new renderer is enough.
 */
export class DeviceLossHandler {
  #isAvailable = true;
  #restoreTimer = 0;
  #host;
  #notices;

  constructor(host: Host, notices: Notices) {
    this.#host = host;
    this.#notices = notices;
    const { canvas, closed: signal } = host;
    signal.addEventListener("abort", () => clearTimeout(this.#restoreTimer));
    canvas.addEventListener("webglcontextlost", (event) => {
      // Without this, the browser does not restore the context.
      event.preventDefault();
      this.#markLost();
    }, { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#replace(), { signal });
    this.watch();
  }

  /** Whether the GPU is available. */
  get isAvailable() {
    return this.#isAvailable;
  }

  /** Waits until the current studio's GPU is lost, then replaces it. WebGPU provides another device immediately. */
  async watch() {
    const { instance } = this.#host;
    this.#markAvailable();
    await this.#host.ask((studio) => studio.gpuLost());
    if (this.#isReplaced(instance)) return;
    this.#markLost();
    await this.#replace();
  }

  #markLost() {
    this.#isAvailable = false;
    clearTimeout(this.#restoreTimer);
    this.#restoreTimer = setTimeout(() => this.#report("the browser did not restore the context"), RESTORE_TIMEOUT_MS);
  }

  #markAvailable() {
    this.#isAvailable = true;
    clearTimeout(this.#restoreTimer);
  }

  async #replace() {
    const { instance, canvas } = this.#host;
    try {
      const renderer = await studioModule().createRenderer(canvas);
      if (this.#isReplaced(instance)) return renderer.free();
      this.#host.answer((studio) => studio.useRenderer(renderer));
      this.watch();
      this.#host.requestFrame();
      this.#notices.hide("gpu");
    } catch (error) {
      if (!this.#isReplaced(instance)) this.#report(asPageError(error).message);
    }
  }

  /** Whether another studio has replaced the one that lost its GPU. */
  #isReplaced(instance: object) {
    return instance !== this.#host.instance || this.#host.closed.aborted;
  }

  #report(message: string) {
    clearTimeout(this.#restoreTimer);
    this.#notices.show({ code: "device-lost", message, hint: "" }, "gpu");
  }
}
