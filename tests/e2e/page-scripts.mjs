// Scripts for the page or its worker that record internals or inject faults.

/** Records worker messages: types in `workerMessages`; progress and the bar's value in `workerProgress`. */
export function recordWorkers() {
  Object.assign(window, { workerMessages: [], workerProgress: [] });
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function (type, listener, ...rest) {
    listen.call(this, type, listener, ...rest);
    if (type !== "message") return;
    listen.call(this, type, ({ data: { type, fraction } }) => {
      window.workerMessages.push(type);
      if (type === "progress") window.workerProgress.push({ fraction, bar: document.getElementById("progress-bar").value });
    });
  };
}

/** Records the page's GPU devices in `gpus`, and whether each is lost. Includes restored WebGL2 contexts. */
export function recordGpus() {
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

/** Crashes the browser's GPU process. @param {import("@playwright/test").Page} page */
export async function crashGpu(page) {
  const browser = await page.context().browser().newBrowserCDPSession();
  await browser.send("Browser.crashGpuProcess");
}

/** Makes the next call of a studio method trap, as a panic does. @param {{ module?: string, method: string }} call */
export async function trapIn({ module = "rosto-studio-web.js", method }) {
  const { prototype } = (await import(new URL(`wasm/${module}`, document.baseURI).href)).Studio;
  const call = prototype[method];
  // (module (func (export "panic") unreachable))
  const code = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 9, 1, 5, 112, 97, 110, 105, 99, 0, 0, 10, 5, 1, 3, 0, 0, 11];
  const { instance } = await WebAssembly.instantiate(new Uint8Array(code));
  prototype[method] = (...values) => {
    prototype[method] = call;
    return instance.exports.panic(...values);
  };
}

/** Makes the worker crash instead of sending a reply. @param {string} reply */
export function crashBefore(reply) {
  const tell = self.postMessage.bind(self);
  self.postMessage = (message, transfer) => {
    if (message.type === reply) throw new WebAssembly.RuntimeError("unreachable");
    tell(message, transfer);
  };
}

/** Refuses the database, as some browsers do in private windows; counts attempts in `refusals`. */
export function refuseDatabase() {
  globalThis.refusals = 0;
  IDBFactory.prototype.open = () => {
    globalThis.refusals += 1;
    throw new DOMException("The operation is insecure.", "SecurityError");
  };
}
