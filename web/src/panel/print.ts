import { byId } from "../page/dom.ts";
import { asPageError } from "../page/page-error.ts";
import type { Host } from "../viewport/host.ts";
import { isWord } from "../words/words.ts";
import type { FaceFiles } from "../work/face-files.ts";

/** Debounce delay: computing a body takes time. */
const DEBOUNCE_MS = 250;

/** Measures the printed body while its panel is visible; the worker computes it. */
export function setUpPrint(host: Host, files: FaceFiles) {
  let timer = 0;
  let latest = 0;
  let isStale = true;
  const fold = () => byId("print", HTMLDetailsElement);
  const refuse = (error: unknown) => {
    // A pending result would hide the reason.
    clearTimeout(timer);
    latest += 1;
    isStale = false;
    const { code, maxMm } = asPageError(error);
    host.applyShown({ report: { "body-failed": { code: isWord(`error.${code}`) ? code : "other", maxMm } } });
  };
  const measure = async () => {
    isStale = false;
    const number = ++latest;
    const result = await files.solidFacts(host.answer((studio) => studio.fileOptions())).then((body) => ({ body }), (error) => ({ error }));
    if (number !== latest || isStale) return;
    if ("error" in result) refuse(result.error);
    else host.applyShown({ report: { "body-measured": result.body } });
  };
  const measureSoon = () => {
    clearTimeout(timer);
    isStale = true;
    if (fold().open && fold().checkVisibility()) timer = setTimeout(measure, DEBOUNCE_MS);
  };
  host.onChange(measureSoon);
  // Measures only while visible, so starts when the fold or its tab opens.
  new ResizeObserver(() => isStale && measureSoon()).observe(fold());
  return { refuse };
}
