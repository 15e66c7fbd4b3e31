import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";

/** Shows the number of network requests after `loaded` has resolved. */
export async function countRequests(loaded: Promise<unknown>) {
  await loaded;
  let count = 0;
  const write = () => {
    const many = count === 0 ? "none" : count === 1 ? "one" : "many";
    const long = byId("privacy-count", HTMLSpanElement);
    long.dataset["requests"] = String(count);
    long.textContent = t(`privacy.${many}`, { n: count });
    byId("privacy-count-short", HTMLSpanElement).textContent = t(`privacy.${many}.short`, { n: count });
  };
  onLocaleChange(write);
  new PerformanceObserver((list) => {
    // Without blob URLs, which are not requests.
    count += list.getEntries().filter(({ name }) => name.startsWith("http")).length;
    write();
  }).observe({ type: "resource" });
}
