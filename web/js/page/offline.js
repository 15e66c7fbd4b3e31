/**
 * Stores the page for use without a network. Resolves when that is done, or when it is clear that it will not be.
 */
export async function keepOffline() {
  if (!("serviceWorker" in navigator)) return;
  try {
    await navigator.serviceWorker.register(new URL("../../service-worker.js", import.meta.url));
    await navigator.serviceWorker.ready;
  } catch {
    // Without it the page works all the same, as long as there is a network.
  }
}
