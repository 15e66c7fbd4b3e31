import { inEveryLanguage, say } from "../words/words.js";
import { byId } from "./dom.js";

/** @type {number | undefined} */
let requestsSinceLoad;

/** Counts the page's network requests from the moment `loaded` says that everything has arrived. */
export async function countRequests(/** @type {Promise<unknown>} */ loaded) {
  inEveryLanguage(write);
  await loaded;
  requestsSinceLoad = 0;
  write();
  const observer = new PerformanceObserver((list) => {
    requestsSinceLoad = (requestsSinceLoad ?? 0) + list.getEntries().filter(wentOut).length;
    write();
  });
  observer.observe({ type: "resource", buffered: false });
}

/**
 * Whether the entry is a request that left for a network: not a blob of the page's own, not an answer from a cache.
 *
 * @param {PerformanceEntry} entry
 */
function wentOut(entry) {
  if (!(entry instanceof PerformanceResourceTiming) || !entry.name.startsWith("http")) return false;
  const ownFile = new URL(entry.name).origin === location.origin;
  return !ownFile || entry.transferSize > 0;
}

function write() {
  const count = byId("privacy-count", HTMLSpanElement);
  count.dataset["requests"] = String(requestsSinceLoad ?? "");
  if (requestsSinceLoad === undefined) count.textContent = "";
  else if (requestsSinceLoad === 0) count.textContent = say("privacy.none");
  else if (requestsSinceLoad === 1) count.textContent = say("privacy.one");
  else count.textContent = say("privacy.many", { n: requestsSinceLoad });
}
