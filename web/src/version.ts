/** Folder of this build of the page, which names its content; undefined elsewhere. */
const VERSION = /\/([0-9a-f]{16})\/[^/]*$/.exec(import.meta.url)?.[1];

/** Shows the service worker that this tab uses its version: see service-worker.ts. */
export function useVersion() {
  if (!VERSION) return;
  let release = () => {};
  const hold = () => navigator.locks?.request(`rosto-${VERSION}`, { mode: "shared" }, () => new Promise<void>((resolve) => (release = resolve)));
  hold();
  // A page with a lock does not enter the back/forward cache.
  addEventListener("pagehide", () => release());
  addEventListener("pageshow", ({ persisted }) => persisted && hold());
}
