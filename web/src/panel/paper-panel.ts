import { announce } from "../page/announce.ts";
import { byId, enableAction, make, onAction } from "../page/dom.ts";
import { trustedSvg } from "../trusted.ts";
import { idName } from "../words/names.ts";
import { onLocaleChange, t, formatNumber } from "../words/words.ts";
import { Stopwatch } from "./stopwatch.ts";
import type { Host, Lease } from "../viewport/host.ts";
import type { PaperMethod, PaperRow, PaperRun } from "../../wasm/rosto-studio-web.js";
import type { WordKey } from "../words/words.ts";

export type Run = Lease<PaperRun>;

export type Measure = "bent" | "stretch" | "flipped" | "smooth" | "timeMs";

/** Random selections of handles and anchors per method. The first equals the command line's first run. */
const RUNS = 5;
const SEED = 0;

const PLOT_PX = { width: 272, height: 220 };

const DECIMALS: Record<Measure, number> = { bent: 3, stretch: 2, flipped: 0, smooth: 0, timeMs: 2 };

/** Runs the paper's experiment on the open face. */
export class PaperPanel {
  #measure = byId("paper-measure", HTMLSelectElement);
  #host;
  /** How long landmark detection took for this face. */
  #extraction_ms: number | undefined;
  #finished: Run | undefined;
  /** Incremented for each face, so that a run detects that its face was replaced. */
  #face = 0;

  constructor(host: Host) {
    this.#host = host;
    onAction("run-paper", () => this.#run());
    this.#measure.addEventListener("change", () => this.#show());
    onLocaleChange(() => this.#show());
  }

  /**
   * Clears the results when another face opens.
   *
   * @param extraction_ms duration of landmark detection, if it was measured
   */
  forget(extraction_ms: number | undefined) {
    this.#extraction_ms = extraction_ms;
    this.#face += 1;
    this.#setResult(undefined);
  }

  async #run() {
    const face = this.#face;
    enableAction("run-paper", false);
    try {
      const run = this.#host.lease((studio) => studio.paperRun(RUNS, SEED));
      const isDone = await this.#runToEnd(run, () => face === this.#face);
      if (isDone) {
        this.#setResult(run);
        announce(t("paper.done"));
      } else run.end();
    } catch (error) {
      this.#host.fail(error);
    }
    byId("paper-progress", HTMLProgressElement).hidden = true;
    enableAction("run-paper", true);
  }

  async #runToEnd(run: Run, isCurrent: () => boolean) {
    const bar = byId("paper-progress", HTMLProgressElement);
    bar.hidden = false;
    const stopwatch = new Stopwatch();
    for (let share = 0; share < 1; share = run.ask((paper) => paper.share)) {
      bar.value = share;
      const took_ms = await stopwatch.time((times) => run.ask((paper) => paper.repeat(times)));
      run.ask((paper) => paper.goOn(took_ms));
      if (!isCurrent()) return false;
    }
    return true;
  }

  #setResult(run: Run | undefined) {
    this.#finished?.end();
    this.#finished = run;
    this.#show();
  }

  #show() {
    byId("paper-results", HTMLDivElement).hidden = !this.#finished;
    this.#finished?.ask((run) => this.#write(run));
  }

  #write(run: PaperRun) {
    const { table, methods, claims } = run.results();
    byId("paper-table", HTMLTableSectionElement).replaceChildren(...table.map((row) => this.#tableRow(row)));
    const { degreeRatio, offsetRatio, smooth, edits } = claims;
    const figures = { degree: formatNumber(degreeRatio, 2), offset: formatNumber(offsetRatio, 2), smooth, edits };
    byId("paper-claims", HTMLParagraphElement).textContent = t("paper.claims", figures);
    byId("paper-plot", HTMLDivElement).replaceChildren(plotOf(run));
    const measure = (this.#measure.value as Measure);
    byId("paper-measure-help", HTMLParagraphElement).textContent = t(`paper.${measure}.help`, { runs: RUNS, edits });
    byId("paper-methods", HTMLTableSectionElement).replaceChildren(...methodRows(methods, measure));
  }

  #tableRow({ task, degree, firstMs, secondMs, hereMs }: PaperRow) {
    const here_ms = task === "extraction" ? this.#extraction_ms : hereMs;
    const here = here_ms === undefined ? t("paper.not-timed") : formatNumber(here_ms, here_ms < 10 ? 2 : 0);
    return tableRow(t((`paper.${task}` as WordKey), { degree }), [formatNumber(firstMs, 0), formatNumber(secondMs, 0), here]);
  }
}

/** One row per operator: soft and exact constraints. */
function methodRows(methods: PaperMethod[], measure: Measure) {
  const operators = [...new Set(methods.map(({ operator }) => operator))];
  return operators.map((operator) => {
    const values = (["soft", "exact"] as const).map((constraint) => {
      const method = methods.find((one) => one.operator === operator && one.constraint === constraint);
      return formatNumber(method?.[measure] ?? 0, DECIMALS[measure]);
    });
    return tableRow(idName("operator", operator), values);
  });
}

function tableRow(heading: string, values: string[]) {
  const row = make("tr");
  const name = make("th", undefined, heading);
  name.scope = "row";
  row.append(name, ...values.map((value) => make("td", undefined, value)));
  return row;
}

function plotOf(run: PaperRun) {
  const { width, height } = PLOT_PX;
  const words = (["title", "degree", "small", "large"] as const).map((word) => t(`paper.plot.${word}`));
  const [title = "", degree = "", small = "", large = ""] = words;
  const svg = run.plot(width, height, title, degree, small, large);
  const picture = new DOMParser().parseFromString(trustedSvg(svg), "image/svg+xml").documentElement;
  picture.setAttribute("role", "img");
  return picture;
}
