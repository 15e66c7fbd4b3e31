// Scripts that run in the page before its own and record what it cannot show.

/** Records the type of each message from a worker in `workersSaid`. */
export function watchWorkers() {
  window.workersSaid = [];
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function (type, listener, ...rest) {
    listen.call(this, type, listener, ...rest);
    if (type === "message") listen.call(this, type, ({ data }) => window.workersSaid.push(data.type));
  };
}

/** Records the devices that the page draws with in `gpus`, also those of WebGL2, and whether each is gone. */
export function watchGpus() {
  window.gpus = [];
  addEventListener("webglcontextrestored", () => window.gpus.push({ isGone: false }), { capture: true });
  const ask = globalThis.GPUAdapter?.prototype.requestDevice;
  if (!ask) return;
  globalThis.GPUAdapter.prototype.requestDevice = async function (...wishes) {
    const device = await ask.apply(this, wishes);
    const gpu = { device, isGone: false };
    window.gpus.push(gpu);
    device.lost.then(() => (gpu.isGone = true));
    return device;
  };
}

/** Ends the browser's graphics process. @param {import("@playwright/test").Page} page */
export async function crashGpu(page) {
  const browser = await page.context().browser().newBrowserCDPSession();
  await browser.send("Browser.crashGpuProcess");
}
