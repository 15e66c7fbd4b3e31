/**
 * Shows a notice if the page does not start. If one module is missing or unsupported, none of them runs, so this is a
 * separate classic script. main.js dispatches "started".
 */
(() => {
  /** Show the notice after this time; it disappears if the page starts later. */
  const TIMEOUT_MS = 20000;

  let hasStarted = false;
  let lacksPart = false;

  // Resource errors do not bubble, so listen in the capture phase.
  addEventListener("error", (event) => {
    const { target } = event;
    const isPart = target instanceof HTMLScriptElement || (target instanceof HTMLLinkElement && target.rel === "stylesheet");
    if (isPart) lacksPart = true;
    if (isPart || (!hasStarted && target === window)) show(true);
  }, true);

  addEventListener("started", () => {
    hasStarted = true;
    show(lacksPart);
  });

  setTimeout(() => {
    if (!hasStarted) show(true);
  }, TIMEOUT_MS);

  /** @param {boolean} isShown */
  function show(isShown) {
    // This script runs before the notice is parsed.
    if (document.readyState === "loading") {
      document.addEventListener("DOMContentLoaded", () => show(isShown), { once: true });
      return;
    }
    const notice = document.getElementById("not-started");
    const again = document.getElementById("start-again");
    if (notice) notice.hidden = !isShown;
    if (again) again.onclick = () => location.reload();
  }
})();
