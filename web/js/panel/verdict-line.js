import { byId } from "../page/dom.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";

/**
 * @typedef {import("../../src/verdict.ts").Verdict} Verdict
 * @typedef {Verdict | "checking" | "unchecked"} Outcome
 * @typedef {{ file: string, bytes?: number, outcome: Outcome }} Shown bytes: file size, once it is made
 */

/** The validator's verdict on the last file. Cleared when the file would change. */
export class VerdictLine {
  #line = byId("verdict", HTMLParagraphElement);
  /** @type {Shown | undefined} */
  #shown;

  /** @param {import("../viewport/host.js").Host} host */
  constructor(host) {
    host.onChange(() => this.show(undefined));
    byId("section-export", HTMLElement).addEventListener("change", () => this.show(undefined));
    onLocaleChange(() => this.#write());
  }

  /**
   * Shows the result of a check, unless the file has changed since the check began.
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
  return t(`verdict.${nameOf(outcome)}`, { file, size: formatBytes(bytes), ...counts });
}

/** @param {number} bytes */
export function formatBytes(bytes) {
  return bytes < 1_000_000 ? `${formatNumber(bytes / 1000, 0)} KB` : `${formatNumber(bytes / 1_000_000, 1)} MB`;
}
