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

/**
 * Runs in the page before its scripts. Counts the calls into each instance of the page's module, keeps their memories, and
 * passes calls of an exported function to `hooked.instead[name]`, if it is set.
 */
export function hookModule() {
  const hooked = { calls: [], memories: [], instead: {} };
  globalThis.hooked = hooked;
  const wrap = (instance) => {
    if (!("__wbg_studio_free" in instance.exports)) return instance;
    const place = hooked.calls.push(0) - 1;
    hooked.memories.push(instance.exports.memory);
    const watched = (name, call) => (...values) => {
      hooked.calls[place] += 1;
      const instead = hooked.instead[name];
      return instead ? instead(call, ...values) : call(...values);
    };
    const exports = Object.entries(instance.exports).map(([name, value]) => [name, typeof value === "function" ? watched(name, value) : value]);
    return { exports: Object.fromEntries(exports) };
  };
  const { instantiateStreaming, Instance } = WebAssembly;
  WebAssembly.instantiateStreaming = async (...source) => {
    const { module, instance } = await instantiateStreaming(...source);
    return { module, instance: wrap(instance) };
  };
  WebAssembly.Instance = new Proxy(Instance, { construct: (_, source) => wrap(new Instance(...source)) });
}

/** Makes the next call of an exported function trap, as a panic does. @param {string} name such as "studio_apply" */
export async function trapIn(name) {
  // (module (func (export "panic") unreachable))
  const code = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 9, 1, 5, 112, 97, 110, 105, 99, 0, 0, 10, 5, 1, 3, 0, 0, 11];
  const { instance } = await WebAssembly.instantiate(new Uint8Array(code));
  const { instead } = globalThis.hooked;
  instead[name] = () => {
    delete instead[name];
    instance.exports.panic();
  };
}

/** Overwrites the memory of the module's current instance. */
export function corruptMemory() {
  new Uint8Array(globalThis.hooked.memories.at(-1).buffer).fill(0xff);
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
