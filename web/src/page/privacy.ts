import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";

let requestsSinceLoad: number | undefined;

/** Counts the network requests after `loaded` has resolved. */
export async function countRequests(loaded: Promise<unknown>) {
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

/** Whether the entry is a network request, not a blob URL. */
function isRequest(entry: PerformanceEntry) {
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
