import { byId } from "../page/dom.js";
import { inEveryLanguage, say, sayNumber } from "../words/words.js";
import { chosen, fileChoices } from "./file-choices.js";
import { withFileChoices } from "../work/written-file.js";
import { saySize } from "./verdict-line.js";

/** @typedef {import("../viewport/workbench.js").Workbench} Workbench */

/** The format that the page's own button downloads. */
const FORMAT = "glb";

/** What the file will hold and be called; how large it is, once it was made. */
export class ExportFacts {
  #bench;
  #nameOf;
  /** @type {number | undefined} of the file as it would be written now */
  #bytes;

  /**
   * @param {Workbench} bench
   * @param {(ending: string) => string} nameOf
   */
  constructor(bench, nameOf) {
    this.#bench = bench;
    this.#nameOf = nameOf;
    bench.onChange(() => this.#forget());
    byId("section-export", HTMLElement).addEventListener("change", () => this.#forget());
    inEveryLanguage(() => this.#write());
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
    const counts = this.#bench.read((state, studio) => (state.vertexCount > 0 ? withFileChoices(fileChoices(), (choices) => studio.meshCounts(FORMAT, choices)) : undefined));
    if (!counts) return;
    const [points = 0, triangles = 0] = counts;
    byId("export-name", HTMLSpanElement).textContent = this.#nameOf(FORMAT);
    byId("export-size", HTMLSpanElement).textContent = this.#bytes === undefined ? "" : saySize(this.#bytes);
    const words = { format: FORMAT.toUpperCase(), points: sayNumber(points, 0), triangles: sayNumber(triangles, 0), paint: this.#paint() };
    byId("export-holds", HTMLParagraphElement).textContent = say("export.holds", words);
  }

  /** What paints it, and how large that is. */
  #paint() {
    const most = this.#bench.read((state) => state.chosen("texture-size")) ?? "";
    const side = this.#bench.read((_, studio) => studio.textureSidePx) ?? "";
    const key = /** @type {const} */ ({ whole: "export.paint.whole", photo: "export.paint.photo", colours: "export.paint.colours" });
    return say(key[/** @type {keyof typeof key} */ (chosen("base-colour"))], { side: String(side), most });
  }
}
