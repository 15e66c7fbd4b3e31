import { byId } from "../page/dom.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";
import { chosen, fileChoices } from "./file-choices.js";
import { formatBytes } from "./verdict-line.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/** The format that the page's own button downloads. */
const FORMAT = "glb";

/** Name and content of the exported file; its size too, once it has been made. */
export class ExportFacts {
  #host;
  #nameOf;
  /** Size of the current file, if it has been made. @type {number | undefined} */
  #bytes;
  /** Number of changes so far. */
  #changes = 0;

  /**
   * @param {Host} host
   * @param {(extension: string) => string} nameOf
   */
  constructor(host, nameOf) {
    this.#host = host;
    this.#nameOf = nameOf;
    host.onChange(() => this.#clear());
    byId("section-export", HTMLElement).addEventListener("change", () => this.#clear());
    onLocaleChange(() => this.#write());
  }

  /** A file is being made. Returns a function that shows its size, unless the face or the options have changed. */
  begin() {
    const changes = this.#changes;
    return (/** @type {number} */ bytes) => {
      if (changes !== this.#changes) return;
      this.#bytes = bytes;
      this.#write();
    };
  }

  #clear() {
    this.#changes += 1;
    this.#bytes = undefined;
    this.#write();
  }

  #write() {
    const { eyes = "skin", expressions = "shape" } = fileChoices();
    const counts = this.#host.read((state, studio) => (state.vertexCount > 0 ? studio.meshCounts(eyes, expressions) : undefined));
    if (!counts) return;
    const [points = 0, triangles = 0] = counts;
    byId("export-name", HTMLSpanElement).textContent = this.#nameOf(FORMAT);
    byId("export-size", HTMLSpanElement).textContent = this.#bytes === undefined ? "" : formatBytes(this.#bytes);
    const words = { format: FORMAT.toUpperCase(), points: formatNumber(points, 0), triangles: formatNumber(triangles, 0), paint: this.#paint() };
    byId("export-holds", HTMLParagraphElement).textContent = t("export.holds", words);
  }

  /** Describes the texture or vertex colours of the file. */
  #paint() {
    const most = this.#host.read((state) => state.chosen["texture-size"]) ?? "";
    const side = this.#host.ask((studio) => studio.textureSidePx) ?? "";
    const key = /** @type {const} */ ({ whole: "export.paint.whole", photo: "export.paint.photo", colours: "export.paint.colours" });
    return t(key[/** @type {keyof typeof key} */ (chosen("base-colour"))], { side: String(side), most });
  }
}
