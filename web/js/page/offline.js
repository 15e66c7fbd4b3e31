/**
 * Stores the page for use without a network. Resolves when that is done, or when it is clear that it will not be.
 *
 * @param {boolean} withFallback whether this browser needs the module that draws through WebGL2, which is stored later
 */
export async function keepOffline(withFallback) {
  if (!("serviceWorker" in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register(new URL("../../service-worker.js", import.meta.url));
    await installed(registration?.installing);
    if (withFallback) registration?.active?.postMessage("keep-fallback");
  } catch {
    // Without it the page works all the same, as long as there is a network.
  }
}

/** @param {ServiceWorker | null | undefined} worker being installed, if one is */
function installed(worker) {
  return new Promise((resolve) => {
    if (!worker) return resolve(undefined);
    worker.addEventListener("statechange", () => {
      if (worker.state === "activated" || worker.state === "redundant") resolve(undefined);
    });
  });
}
