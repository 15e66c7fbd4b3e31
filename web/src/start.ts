/**
 * Shows a notice if the page does not start. A separate classic script, because the page's own may be missing or
 * unsupported. `page.js` dispatches "started".
 */

const folder = (document.currentScript as HTMLScriptElement).src.replace(/[^/]*$/, "");
// While the page's script arrives. Browsers without WebGPU use another module.
if ("gpu" in navigator) {
  const preload = { rel: "preload", as: "fetch", crossOrigin: "", href: `${folder}rosto-studio-web_bg.wasm` };
  document.head.append(Object.assign(document.createElement("link"), preload));
}

/** Show the notice after this time; it disappears if the page starts later. */
const TIMEOUT_MS = 20_000;

let hasStarted = false;
let lacksPart = false;

// Resource errors do not bubble, so listen in the capture phase.
addEventListener("error", ({ target }) => {
  const isStyle = target instanceof HTMLLinkElement && target.rel === "stylesheet";
  const isPart = isStyle || target instanceof HTMLScriptElement;
  lacksPart ||= isPart;
  if (isPart || (!hasStarted && target === window)) show(true);
}, true);

addEventListener("started", () => {
  hasStarted = true;
  show(lacksPart);
});

setTimeout(() => {
  if (!hasStarted) show(true);
}, TIMEOUT_MS);

function show(isShown: boolean) {
  const notice = document.getElementById("not-started");
  // This script runs before the notice is parsed.
  if (!notice) return addEventListener("DOMContentLoaded", () => show(isShown), { once: true });
  notice.toggleAttribute("data-shown", isShown);
  document.getElementById("start-again")?.addEventListener("click", reload);
}

/** Reloads the page and its parts, of which the browser may keep a damaged copy. */
async function reload(event: Event) {
  event.preventDefault();
  const parts = [...document.querySelectorAll<HTMLScriptElement>("script[src]")].map(({ src }) => src);
  await Promise.allSettled(parts.map((part) => fetch(part, { cache: "reload" })));
  location.reload();
}
