/**
 * Says that the page did not start: a module that does not arrive, or that this browser cannot read, takes all others
 * with it, and with them every word the page could say. A classic script that needs none of them; main.js
 * sends "started" when it has come to its end.
 */
(() => {
  /** After this long without a start the page says so; it takes that back if it starts after all. */
  const PATIENCE_MS = 20000;

  let hasStarted = false;
  let lacksPart = false;

  // The loading of an element fails without bubbling.
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
  }, PATIENCE_MS);

  /** @param {boolean} isShown */
  function show(isShown) {
    // The notice comes after this script: a failure may be faster than it.
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
