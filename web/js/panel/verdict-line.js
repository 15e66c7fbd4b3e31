import { byId } from "../page/dom.js";
import { inEveryLanguage, say, sayNumber } from "../words/words.js";

/**
 * @typedef {import("../worker/protocol.js").Verdict} Verdict
 * @typedef {Verdict | "checking" | "unchecked"} Outcome
 * @typedef {{ file: string, bytes?: number, outcome: Outcome }} Shown bytes: how many the file has, once it is made
 */

/** What the validator said of the last file; gone as soon as the next file would be another one. */
export class VerdictLine {
  #line = byId("verdict", HTMLParagraphElement);
  /** @type {Shown | undefined} */
  #shown;

  /** @param {import("../viewport/workbench.js").Workbench} bench */
  constructor(bench) {
    bench.onChange(() => this.show(undefined));
    byId("section-export", HTMLElement).addEventListener("change", () => this.show(undefined));
    inEveryLanguage(() => this.#write());
  }

  /**
   * Shows what came of a check, unless the file would be another one by now.
   *
   * @param {Shown} shown
   */
  conclude(shown) {
    if (this.#shown?.outcome === "checking") this.show(shown);
  }

  /** @param {Shown | undefined} shown */
  show(shown) {
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.#write();
  }

  #write() {
    const shown = this.#shown;
    this.#line.hidden = !shown;
    this.#line.dataset["verdict"] = shown ? nameOf(shown.outcome) : "nothing";
    this.#line.textContent = shown ? words(shown) : "";
  }
}

/**
 * @param {Outcome} outcome
 * @returns {"checking" | "unchecked" | "valid" | "invalid"}
 */
function nameOf(outcome) {
  if (typeof outcome === "string") return outcome;
  return outcome.errors === 0 ? "valid" : "invalid";
}

/** @param {Shown} shown */
function words({ file, bytes = 0, outcome }) {
  const counts = typeof outcome === "string" ? {} : outcome;
  return say(`verdict.${nameOf(outcome)}`, { file, size: saySize(bytes), ...counts });
}

/** @param {number} bytes */
export function saySize(bytes) {
  return bytes < 1_000_000 ? `${sayNumber(bytes / 1000, 0)} KB` : `${sayNumber(bytes / 1_000_000, 1)} MB`;
}
