import { byId } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";

/**
 * @typedef {import("../worker/protocol.js").Verdict} Verdict
 * @typedef {Verdict | "checking" | "unchecked" | "nothing"} Shown
 */

/** What the validator said of the last file; gone as soon as the next file would be another one. */
export class VerdictLine {
  #line = byId("verdict", HTMLParagraphElement);
  /** @type {Shown} */
  #shown = "nothing";

  /** @param {import("../viewport/workbench.js").Workbench} bench */
  constructor(bench) {
    bench.onChange(() => this.show("nothing"));
    byId("section-export", HTMLDetailsElement).addEventListener("change", () => this.show("nothing"));
    inEveryLanguage(() => this.#write());
  }

  /**
   * Shows what came of a check, unless the file would be another one by now.
   *
   * @param {Shown} shown
   */
  conclude(shown) {
    if (this.#shown === "checking") this.show(shown);
  }

  /** @param {Shown} shown */
  show(shown) {
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.#write();
  }

  #write() {
    const shown = this.#shown;
    this.#line.hidden = shown === "nothing";
    this.#line.dataset["verdict"] = typeof shown === "string" ? shown : shown.errors === 0 ? "valid" : "invalid";
    this.#line.textContent = words(shown);
  }
}

/** @param {Shown} shown */
function words(shown) {
  if (shown === "nothing") return "";
  if (shown === "checking") return say("verdict.checking");
  if (shown === "unchecked") return say("verdict.unchecked");
  return say(shown.errors === 0 ? "verdict.valid" : "verdict.invalid", shown);
}
