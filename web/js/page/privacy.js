import { onLocaleChange, t } from "../words/words.js";
import { byId } from "../../src/dom.ts";

/** @type {number | undefined} */
let requestsSinceLoad;

/** Counts the network requests after `loaded` has resolved. */
export async function countRequests(/** @type {Promise<unknown>} */ loaded) {
  onLocaleChange(write);
  await loaded;
  requestsSinceLoad = 0;
  write();
  const observer = new PerformanceObserver((list) => {
    requestsSinceLoad = (requestsSinceLoad ?? 0) + list.getEntries().filter(isRequest).length;
    write();
  });
  observer.observe({ type: "resource", buffered: false });
}

/** Whether the entry is a network request, not a blob URL. @param {PerformanceEntry} entry */
function isRequest(entry) {
  return entry.name.startsWith("http");
}

function write() {
  const count = byId("privacy-count", HTMLSpanElement);
  const short = byId("privacy-count-short", HTMLSpanElement);
  count.dataset["requests"] = String(requestsSinceLoad ?? "");
  if (requestsSinceLoad === undefined) return;
  const many = requestsSinceLoad === 0 ? "none" : requestsSinceLoad === 1 ? "one" : "many";
  count.textContent = t(`privacy.${many}`, { n: requestsSinceLoad });
  short.textContent = t(`privacy.${many}.short`, { n: requestsSinceLoad });
}
