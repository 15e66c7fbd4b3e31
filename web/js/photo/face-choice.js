import { byId, make } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";
import { faceBox } from "./face-box.js";

/** @typedef {import("../worker/protocol.js").FoundFaces} FoundFaces */

const THUMBNAIL_PX = 56;
/** How much of the photo around a face its thumbnail shows, in sizes of the face. */
const MARGIN = 0.25;

/** The faces of a photo that has several, to choose from. */
export class FaceChoice {
  #element = byId("face-choice", HTMLFieldSetElement);
  #choose;
  #count = 0;

  /** @param {(index: number) => void} choose */
  constructor(choose) {
    this.#choose = choose;
    inEveryLanguage(() => this.#write());
  }

  /**
   * Offers the faces, the first one chosen; nothing to choose shows nothing.
   *
   * @param {FoundFaces} found
   */
  async show(found) {
    this.#count = found.faces.length;
    this.#element.hidden = this.#count < 2;
    this.#write();
    if (this.#count < 2) return;
    const faces = await Promise.all(found.faces.map((_, index) => thumbnail(found, index)));
    const options = faces.map((face, index) => {
      const label = make("label");
      const input = make("input");
      input.type = "radio";
      input.name = "face";
      input.checked = index === 0;
      input.setAttribute("aria-label", say("face.number", { n: index + 1 }));
      input.addEventListener("change", () => this.#choose(index));
      label.append(input, face);
      return label;
    });
    byId("face-options", HTMLDivElement).replaceChildren(...options);
  }

  /** Takes the choice away. */
  hide() {
    this.#element.hidden = true;
  }

  #write() {
    byId("face-choice-title", HTMLLegendElement).textContent = say("face.several", { n: this.#count });
  }
}

/**
 * @param {FoundFaces} found
 * @param {number} index
 */
async function thumbnail(found, index) {
  const box = boxOf(found, index);
  const side_px = THUMBNAIL_PX * devicePixelRatio;
  const bitmap = await createImageBitmap(found.bitmap, box.left, box.top, box.side, box.side);
  const canvas = make("canvas");
  canvas.width = side_px;
  canvas.height = side_px;
  canvas.getContext("2d")?.drawImage(bitmap, 0, 0, side_px, side_px);
  bitmap.close();
  return canvas;
}

/**
 * The square around a face, in px of the picture.
 *
 * @param {FoundFaces} found
 * @param {number} index
 */
function boxOf(found, index) {
  const landmarks = found.faces[index]?.landmarks ?? new Float32Array();
  const { x, y, side: size } = faceBox(landmarks, found.pictureWidth_px, found.pictureHeight_px);
  const side = size * (1 + 2 * MARGIN);
  return { left: Math.round(x - side / 2), top: Math.round(y - side / 2), side: Math.round(side) };
}
