import { byId, make } from "../page/dom.js";
import { asPageError } from "../page/page-error.js";
import { idName } from "../words/names.js";
import { onLocaleChange, isWord, t, formatNumber } from "../words/words.js";
import { chosen, hasLength, printChoices } from "./file-choices.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../worker/protocol.js").SolidFacts} SolidFacts
 * @typedef {import("../words/words.js").WordKey} WordKey
 */

/** Debounce delay: computing a body takes time. */
const DEBOUNCE_MS = 250;

/** Rounding below this is not visible, in mm. */
const VISIBLE_MM = 0.05;

/** Print options, the measurements of the body, and the reason if it cannot be made. */
export class PrintPanel {
  #files;
  #fold = byId("export-print", HTMLDetailsElement);
  #length = byId("solid-mm", HTMLInputElement);
  #facts = byId("print-facts", HTMLDListElement);
  #errorLine = byId("print-refused", HTMLParagraphElement);
  /** Length entered for each shape that has one, in mm. @type {Record<string, string>} */
  #lengths_mm = { thickness: "2", flat: "3" };
  #range_mm;
  /** @type {SolidFacts | undefined} */
  #body;
  /** @type {unknown} */
  #error;
  #isStale = true;
  #timer = 0;
  /** Identifies the latest measurement. */
  #measured = 0;

  /**
   * @param {Host} host
   * @param {import("../work/face-files.js").FaceFiles} files
   */
  constructor(host, files) {
    this.#files = files;
    this.#range_mm = host.catalogue.solidMm;
    const [least = 0, most = 0] = this.#range_mm;
    Object.assign(this.#length, { min: String(least), max: String(most) });
    this.#offerLength();
    this.#fold.addEventListener("change", () => this.#offerLength());
    this.#fold.addEventListener("input", () => this.#measureSoon());
    this.#length.addEventListener("input", () => (this.#lengths_mm[chosen("solid")] = this.#length.value));
    host.onChange(() => this.#measureSoon());
    // Measure only while visible, so start when the section or its tab opens.
    new ResizeObserver(() => this.#isStale && this.#measureSoon()).observe(this.#fold);
    onLocaleChange(() => this.#write());
  }

  /** Shows why the file was not written. @param {unknown} error */
  showError(error) {
    this.#error = error;
    this.#body = undefined;
    this.#write();
  }

  /** Restores the length entered for the chosen shape. */
  #offerLength() {
    const length_mm = this.#lengths_mm[chosen("solid")];
    if (length_mm !== undefined && this.#length.value !== length_mm) this.#length.value = length_mm;
    this.#write();
  }

  #measureSoon() {
    clearTimeout(this.#timer);
    this.#isStale = true;
    this.#fold.dataset["measuring"] = "";
    if (this.#fold.open && this.#fold.checkVisibility()) this.#timer = setTimeout(() => this.#measure(), DEBOUNCE_MS);
  }

  async #measure() {
    this.#isStale = false;
    const number = ++this.#measured;
    const result = await this.#files.solidFacts(printChoices()).then((body) => ({ body }), (error) => ({ error }));
    if (number !== this.#measured || this.#isStale) return;
    delete this.#fold.dataset["measuring"];
    if ("error" in result) return this.showError(result.error);
    this.#error = undefined;
    this.#body = result.body;
    this.#write();
  }

  #write() {
    const solid = chosen("solid");
    byId("solid-length", HTMLDivElement).hidden = !hasLength(solid);
    if (hasLength(solid)) byId("solid-mm-label", HTMLLabelElement).textContent = idName("solid", `${solid}.mm`);
    byId("solid-help", HTMLParagraphElement).textContent = idName("solid", `${solid}.help`);
    this.#facts.replaceChildren(...(this.#body ? factRows(this.#body) : []));
    this.#errorLine.hidden = this.#error === undefined;
    this.#errorLine.textContent = this.#error === undefined ? "" : this.#errorText();
    this.#length.setAttribute("aria-invalid", String(this.#error !== undefined && hasLength(solid)));
  }

  /** Error text with an allowed length, if there is one. */
  #errorText() {
    const [least = 0, most = 0] = this.#range_mm;
    const { code, maxMm = 0 } = asPageError(this.#error);
    if (code === "bad-choice") return t("print.range", { least: formatNumber(least, 1), most: formatNumber(most, 0) });
    // Rounded down so that the suggested length works.
    const works_mm = Math.floor(10 * maxMm) / 10;
    if (works_mm >= least) return t("print.at-most", { most: formatNumber(works_mm, 1) });
    const key = isWord(`error.${code}`) ? code : "other";
    return `${t(/** @type {WordKey} */ (`error.${key}`))}. ${t(/** @type {WordKey} */ (`error.${key}.hint`))}`;
  }
}

/** @param {SolidFacts} body */
function factRows({ volumeCm3, sizeMm, thinnestMm, movedMm, plaGrams }) {
  const rows = [
    ["size", `${sizeMm.map((side) => formatNumber(side, 0)).join(" × ")} mm`],
    ["volume", `${formatNumber(volumeCm3, 1)} cm³`],
    ["weight", `${formatNumber(plaGrams, 0)} g`],
    ["thinnest", `${formatNumber(thinnestMm, 1)} mm`],
    ...(movedMm < VISIBLE_MM ? [] : [["rounded", `${formatNumber(movedMm, 1)} mm`]]),
  ];
  return rows.flatMap(([name, value]) => [make("dt", "", idName("print", name ?? "")), make("dd", "", value)]);
}
