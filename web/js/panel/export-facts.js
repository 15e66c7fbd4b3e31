import { byId } from "../page/dom.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";
import { chosen, fileChoices } from "./file-choices.js";
import { withFileChoices } from "../work/written-file.js";
import { formatBytes } from "./verdict-line.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/** The format that the page's own button downloads. */
const FORMAT = "glb";

/** What the file will hold and be called; how large it is, once it was made. */
export class ExportFacts {
  #host;
  #nameOf;
  /** @type {number | undefined} of the file as it would be written now */
  #bytes;

  /**
   * @param {Host} host
   * @param {(ending: string) => string} nameOf
   */
  constructor(host, nameOf) {
    this.#host = host;
    this.#nameOf = nameOf;
    host.onChange(() => this.#forget());
    byId("section-export", HTMLElement).addEventListener("change", () => this.#forget());
    onLocaleChange(() => this.#write());
  }

  /** @param {Blob} file as it was just made */
  tell(file) {
    this.#bytes = file.size;
    this.#write();
  }

  #forget() {
    this.#bytes = undefined;
    this.#write();
  }

  #write() {
    const counts = this.#host.read((state, studio) => (state.vertexCount > 0 ? withFileChoices(fileChoices(), (choices) => studio.meshCounts(FORMAT, choices)) : undefined));
    if (!counts) return;
    const [points = 0, triangles = 0] = counts;
    byId("export-name", HTMLSpanElement).textContent = this.#nameOf(FORMAT);
    byId("export-size", HTMLSpanElement).textContent = this.#bytes === undefined ? "" : formatBytes(this.#bytes);
    const words = { format: FORMAT.toUpperCase(), points: formatNumber(points, 0), triangles: formatNumber(triangles, 0), paint: this.#paint() };
    byId("export-holds", HTMLParagraphElement).textContent = t("export.holds", words);
  }

  /** What paints it, and how large that is. */
  #paint() {
    const most = this.#host.read((state) => state.chosen("texture-size")) ?? "";
    const side = this.#host.read((_, studio) => studio.textureSidePx) ?? "";
    const key = /** @type {const} */ ({ whole: "export.paint.whole", photo: "export.paint.photo", colours: "export.paint.colours" });
    return t(key[/** @type {keyof typeof key} */ (chosen("base-colour"))], { side: String(side), most });
  }
}
