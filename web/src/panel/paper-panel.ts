import { announce } from "../page/announce.ts";
import { byId, enableAction, make, onAction } from "../page/dom.ts";
import { trustedSvg } from "../trusted.ts";
import { idName } from "../words/names.ts";
import { formatNumber, isWord, onLocaleChange, t } from "../words/words.ts";
import type { Host } from "../viewport/host.ts";
import type { WordKey } from "../words/words.ts";
import type { FaceFiles } from "../work/face-files.ts";
import type { PaperMethod, PaperResults } from "../../wasm/rosto-vision-web.js";

/** Decimals of the measures. */
const DECIMALS = { bent: 3, stretch: 2, flipped: 0, smooth: 0, timeMs: 2 };

type Measure = keyof typeof DECIMALS;

/**
 * Sets up the paper's experiment on the open face, which the worker runs. Returns a function that forgets the results
 * when another face opens, with the time in ms that finding its landmarks took, if that was measured.
 */
export function setUpPaper(host: Host, files: FaceFiles) {
  const measure = byId("paper-measure", HTMLSelectElement);
  const bar = byId("paper-progress", HTMLProgressElement);
  let results: PaperResults | undefined;
  let extraction_ms: number | undefined;
  /** Number of the open face. */
  let face = 0;
  const show = () => {
    byId("paper-results", HTMLDivElement).hidden = !results;
    if (results) write(results, measure.value as Measure, extraction_ms);
  };
  const run = async () => {
    const ofFace = face;
    enableAction("run-paper", false);
    [bar.hidden, bar.value] = [false, 0];
    try {
      const found = await files.paper((share) => (bar.value = share));
      if (ofFace === face && found) {
        results = found;
        announce(t("paper.done"));
      }
      show();
    } catch (error) {
      host.fail(error);
    }
    bar.hidden = true;
    enableAction("run-paper", true);
  };
  onAction("run-paper", run);
  measure.addEventListener("change", show);
  onLocaleChange(show);
  return (duration_ms: number | undefined) => {
    face += 1;
    if (!bar.hidden) files.stopPaper();
    [extraction_ms, results] = [duration_ms, undefined];
    show();
  };
}

function write({ table, methods, claims, plot }: PaperResults, measure: Measure, extraction_ms: number | undefined) {
  const rows = table.map(({ task, degree, firstMs, secondMs, hereMs }) => {
    const here_ms = task === "extraction" ? extraction_ms : hereMs;
    const here = here_ms === undefined ? t("paper.not-timed") : formatNumber(here_ms, here_ms < 10 ? 2 : 0);
    const heading = t(`paper.${task}` as WordKey, { degree });
    return tableRow(heading, [formatNumber(firstMs, 0), formatNumber(secondMs, 0), here]);
  });
  byId("paper-table", HTMLTableSectionElement).replaceChildren(...rows);
  const { degreeRatio, offsetRatio, smooth, edits } = claims;
  const figures = { degree: formatNumber(degreeRatio, 2), offset: formatNumber(offsetRatio, 2), smooth, edits };
  byId("paper-claims", HTMLParagraphElement).textContent = t("paper.claims", figures);
  byId("paper-plot", HTMLDivElement).replaceChildren(picture(plot));
  const runs = claims.runs;
  byId("paper-measure-help", HTMLParagraphElement).textContent = t(`paper.${measure}.help`, { runs, edits });
  byId("paper-methods", HTMLTableSectionElement).replaceChildren(...methodRows(methods, measure));
}

/** One row per operator: soft and exact constraints. */
function methodRows(methods: PaperMethod[], measure: Measure) {
  const operators = [...new Set(methods.map(({ operator }) => operator))];
  return operators.map((operator) => {
    const values = ["soft", "exact"].map((constraint) => {
      const method = methods.find((one) => one.operator === operator && one.constraint === constraint);
      return formatNumber(method?.[measure] ?? 0, DECIMALS[measure]);
    });
    return tableRow(idName("operator", operator), values);
  });
}

function tableRow(heading: string, values: string[]) {
  const name = make("th", "", heading);
  name.scope = "row";
  return make("tr", "", name, ...values.map((value) => make("td", "", value)));
}

/** The plot with its texts, which start with ids of words. */
function picture(plot: string) {
  const svg = new DOMParser().parseFromString(trustedSvg(plot), "image/svg+xml").documentElement;
  for (const text of svg.querySelectorAll("text, title")) {
    text.textContent = text.textContent.replace(/^\S+/, (id) => (isWord(id) ? t(id) : id));
  }
  svg.setAttribute("role", "img");
  return svg;
}
