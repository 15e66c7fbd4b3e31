import { byId, make } from "../page/dom.js";
import { onLocaleChange, t } from "../words/words.js";
import { faceBox } from "./face-box.js";

/** @typedef {import("../work/work.js").OpenedFace} OpenedFace */

const THUMBNAIL_PX = 56;
/** Margin around a face in its thumbnail, relative to the face. */
const MARGIN = 0.25;

/** Strip over the stage: the faces of a photo with several faces, and the recent faces. */
export class FaceChoice {
  #strip = byId("faces", HTMLElement);
  #group = byId("face-choice", HTMLFieldSetElement);
  #previous = byId("previous-face", HTMLButtonElement);
  #earlier = byId("earlier-faces", HTMLDivElement);
  /** Shown before, latest first. @type {OpenedFace[]} */
  #before = [];
  /** @type {OpenedFace[]} */
  #faces = [];
  /** @type {OpenedFace | undefined} */
  #shown;
  /** @type {WeakMap<OpenedFace, Promise<ImageBitmap>>} */
  #thumbnails = new WeakMap();
  #choose;
  #goBackTo;

  /**
   * @param {(face: OpenedFace) => void} choose
   * @param {(face: OpenedFace) => void} goBackTo
   */
  constructor(choose, goBackTo) {
    this.#choose = choose;
    this.#goBackTo = goBackTo;
    this.#previous.addEventListener("click", () => this.#before[0] && goBackTo(this.#before[0]));
    onLocaleChange(() => this.#updateLabels());
  }

  /**
   * Shows the faces of a photo and the recent faces; hides the strip if there is nothing to choose.
   *
   * @param {OpenedFace[]} faces
   * @param {OpenedFace[]} before latest first
   * @param {ImageBitmap} bitmap picture of the faces
   */
  async show(faces, before, bitmap) {
    const isGroup = faces.length > 1;
    for (const face of faces) this.#createThumbnail(face, bitmap);
    this.#group.hidden = !isGroup;
    this.#previous.hidden = before.length === 0;
    this.#strip.hidden = !isGroup && before.length === 0;
    this.#before = before;
    const [latest, ...earlier] = before;
    const drawing = [this.#draw(byId("previous-thumbnail", HTMLCanvasElement), latest), ...this.#showEarlier(earlier)];
    if (faces !== this.#faces) drawing.push(...this.#showFaces(faces));
    await Promise.all(drawing);
  }

  /** @param {OpenedFace[]} faces of earlier photos */
  #showEarlier(faces) {
    const buttons = faces.map((face) => {
      const button = make("button", "previous-face");
      button.type = "button";
      button.addEventListener("click", () => this.#goBackTo(face));
      return { button, canvas: make("canvas"), face };
    });
    for (const { button, canvas } of buttons) button.append(canvas);
    this.#earlier.replaceChildren(...buttons.map(({ button }) => button));
    this.#updateLabels();
    return buttons.map(({ canvas, face }) => this.#draw(canvas, face));
  }

  /** Checks the radio button of the current face. @param {OpenedFace | undefined} shown */
  mark(shown) {
    this.#shown = shown;
    for (const [index, input] of this.#inputs().entries()) {
      input.checked = this.#faces[index] === shown;
      if (input.checked) input.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }

  /** @param {OpenedFace[]} faces */
  #showFaces(faces) {
    this.#faces = faces;
    const options = faces.length < 2 ? [] : faces.map((face) => ({ face, canvas: make("canvas"), label: this.#option(face) }));
    for (const { label, canvas } of options) label.append(canvas);
    byId("face-options", HTMLDivElement).replaceChildren(...options.map(({ label }) => label));
    this.#updateLabels();
    this.mark(this.#shown);
    return options.map(({ canvas, face }) => this.#draw(canvas, face));
  }

  /** @param {OpenedFace} face */
  #option(face) {
    const label = make("label");
    const input = make("input");
    input.type = "radio";
    input.name = "face";
    input.addEventListener("change", () => this.#choose(face));
    label.append(input);
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
   * Created once, while the picture is available.
   *
   * @param {OpenedFace} face
   * @param {ImageBitmap} bitmap
   */
  #createThumbnail(face, bitmap) {
    if (this.#thumbnails.has(face)) return;
    const { left, top, side } = boxOf(face);
    const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
    const size = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: /** @type {const} */ ("high") };
    this.#thumbnails.set(face, createImageBitmap(bitmap, left, top, side, side, size));
  }

  #updateLabels() {
    byId("face-choice-title", HTMLLegendElement).textContent = t("face.several", { n: this.#faces.length });
    for (const [index, input] of this.#inputs().entries()) input.setAttribute("aria-label", t("face.number", { n: index + 1 }));
    for (const [index, button] of this.#earlier.querySelectorAll("button").entries()) {
      const label = t("face.earlier", { name: this.#before[index + 1]?.name ?? "" });
      button.setAttribute("aria-label", label);
      button.title = label;
    }
  }

  #inputs() {
    return this.#group.querySelectorAll("input");
  }
}

/**
 * Square crop around a face, in px of its picture.
 *
 * @param {OpenedFace} face
 */
function boxOf({ landmarks, pictureWidth_px, pictureHeight_px }) {
  const { x, y, side: size } = faceBox(landmarks, pictureWidth_px, pictureHeight_px);
  const side = size * (1 + 2 * MARGIN);
  return { left: Math.round(x - side / 2), top: Math.round(y - side / 2), side: Math.max(1, Math.round(side)) };
}
