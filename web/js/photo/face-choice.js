import { byId, make } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";
import { faceBox } from "./face-box.js";

/** @typedef {import("../work/work.js").OpenedFace} OpenedFace */

const THUMBNAIL_PX = 56;
/** How much of the photo around a face its thumbnail shows, in sizes of the face. */
const MARGIN = 0.25;

/** Over the stage: the faces of a photo that has several, and the way back to the face that was shown before. */
export class FaceChoice {
  #strip = byId("faces", HTMLElement);
  #group = byId("face-choice", HTMLFieldSetElement);
  #previous = byId("previous-face", HTMLButtonElement);
  /** @type {OpenedFace[]} */
  #faces = [];
  /** @type {OpenedFace | undefined} */
  #shown;
  /** @type {WeakMap<OpenedFace, Promise<ImageBitmap>>} */
  #thumbnails = new WeakMap();
  #choose;

  /**
   * @param {(index: number) => void} choose
   * @param {() => void} goBack
   */
  constructor(choose, goBack) {
    this.#choose = choose;
    this.#previous.addEventListener("click", goBack);
    inEveryLanguage(() => this.#write());
  }

  /**
   * Offers the faces of a photo and the one that was shown before them; nothing to choose shows nothing.
   *
   * @param {OpenedFace[]} faces
   * @param {OpenedFace | undefined} before
   * @param {ImageBitmap} bitmap the picture of the faces
   */
  async show(faces, before, bitmap) {
    const isGroup = faces.length > 1;
    for (const face of faces) this.#thumbnailOf(face, bitmap);
    if (faces !== this.#faces) this.#offer(faces);
    this.#group.hidden = !isGroup;
    this.#previous.hidden = before === undefined;
    this.#strip.hidden = !isGroup && before === undefined;
    await this.#draw(byId("previous-thumbnail", HTMLCanvasElement), before);
  }

  /** @param {OpenedFace | undefined} shown is the one that is chosen, whatever was pressed meanwhile */
  mark(shown) {
    this.#shown = shown;
    for (const [index, input] of this.#inputs().entries()) {
      input.checked = this.#faces[index] === shown;
      if (input.checked) input.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }

  /** @param {OpenedFace[]} faces */
  #offer(faces) {
    this.#faces = faces;
    const options = faces.length < 2 ? [] : faces.map((face, index) => this.#option(face, index));
    byId("face-options", HTMLDivElement).replaceChildren(...options);
    this.#write();
    this.mark(this.#shown);
  }

  /**
   * @param {OpenedFace} face
   * @param {number} index
   */
  #option(face, index) {
    const label = make("label");
    const input = make("input");
    input.type = "radio";
    input.name = "face";
    input.addEventListener("change", () => this.#choose(index));
    const canvas = make("canvas");
    label.append(input, canvas);
    this.#draw(canvas, face);
    return label;
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {OpenedFace | undefined} face
   */
  async #draw(canvas, face) {
    const thumbnail = await (face && this.#thumbnails.get(face));
    if (!thumbnail) return;
    [canvas.width, canvas.height] = [thumbnail.width, thumbnail.height];
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
  }

  /**
   * Is made once, while the picture is at hand.
   *
   * @param {OpenedFace} face
   * @param {ImageBitmap} bitmap
   */
  #thumbnailOf(face, bitmap) {
    if (this.#thumbnails.has(face)) return;
    const { left, top, side } = boxOf(face);
    const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
    const size = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: /** @type {const} */ ("high") };
    this.#thumbnails.set(face, createImageBitmap(bitmap, left, top, side, side, size));
  }

  #write() {
    byId("face-choice-title", HTMLLegendElement).textContent = say("face.several", { n: this.#faces.length });
    for (const [index, input] of this.#inputs().entries()) input.setAttribute("aria-label", say("face.number", { n: index + 1 }));
  }

  #inputs() {
    return this.#group.querySelectorAll("input");
  }
}

/**
 * The square around a face, in px of its picture.
 *
 * @param {OpenedFace} face
 */
function boxOf({ landmarks, pictureWidth_px, pictureHeight_px }) {
  const { x, y, side: size } = faceBox(landmarks, pictureWidth_px, pictureHeight_px);
  const side = size * (1 + 2 * MARGIN);
  return { left: Math.round(x - side / 2), top: Math.round(y - side / 2), side: Math.max(1, Math.round(side)) };
}
