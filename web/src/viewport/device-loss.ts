import { asPageError } from "../page/page-error.ts";
import { studioModule } from "../studio-module.ts";
import type { Host, Notices } from "./host.ts";

/** Time to wait for the browser to restore a WebGL2 context before a notice appears. */
const RESTORE_TIMEOUT_MS = 4000;

/**
 * Recovers from a lost GPU, for example after a driver reset. The session is in memory, so a new renderer is enough.
 * Returns whether the GPU is available, and a function that watches the GPU of a new studio.
 */
export function followGpu(host: Host, notices: Notices) {
  const { canvas, closed: signal } = host;
  const gpu = { isAvailable: true, watch };
  let timer = 0;
  const report = (message: string) => notices.show({ code: "device-lost", message, hint: "" }, "gpu");
  const setAvailable = (isAvailable: boolean) => {
    gpu.isAvailable = isAvailable;
    clearTimeout(timer);
    if (!isAvailable) timer = setTimeout(report, RESTORE_TIMEOUT_MS, "the browser did not restore the context");
  };
  /** Whether another studio has replaced the one that lost its GPU. */
  const isReplaced = (instance: object) => instance !== host.instance || signal.aborted;

  async function watch() {
    const { instance } = host;
    setAvailable(true);
    await host.ask((studio) => studio.gpuLost());
    if (isReplaced(instance)) return;
    setAvailable(false);
    // WebGPU provides another device immediately, WebGL2 only after its event.
    await replace();
  }

  async function replace() {
    const { instance } = host;
    try {
      const renderer = await studioModule().createRenderer(canvas);
      if (isReplaced(instance)) return renderer.free();
      host.answer((studio) => studio.useRenderer(renderer));
      watch();
      host.requestFrame();
      notices.hide("gpu");
    } catch (error) {
      if (isReplaced(instance)) return;
      clearTimeout(timer);
      report(asPageError(error).message);
    }
  }

  signal.addEventListener("abort", () => clearTimeout(timer));
  canvas.addEventListener("webglcontextlost", (event) => {
    // Without this, the browser does not restore the context.
    event.preventDefault();
    setAvailable(false);
  }, { signal });
  canvas.addEventListener("webglcontextrestored", replace, { signal });
  watch();
  return gpu;
}
