import { byId, make } from "../page/dom.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { faceBox } from "./face-box.ts";
import type { Face } from "../work/face.ts";

const THUMBNAIL_PX = 56;
/** Margin around a face in its thumbnail, relative to the face. */
const MARGIN = 0.25;

/** Strip over the stage: the faces of a photo with several faces, and the recent faces. */
export class FaceChoice {
  #strip = byId("faces", HTMLElement);
  #group = byId("face-choice", HTMLFieldSetElement);
  #previous = byId("previous-face", HTMLButtonElement);
  #earlier = byId("earlier-faces", HTMLDivElement);
  /** Shown before, latest first. */
  #before: Face[] = [];
  #faces: Face[] = [];
  #shown: Face | undefined;
  /** `lead`: picture that was drawn. */
  #thumbnails: WeakMap<Face, { lead: string | undefined; bitmap: Promise<ImageBitmap>; }> = new WeakMap();
  #choose;

  constructor(choose: (face: Face) => void) {
    this.#choose = choose;
    this.#previous.addEventListener("click", () => this.#before[0] && choose(this.#before[0]));
    onLocaleChange(() => this.#updateLabels());
  }

  /** Makes the thumbnails of the faces of a photo, while its picture is available. */
  prepare(faces: Face[], picture: ImageBitmap) {
    for (const face of faces) this.#createThumbnail(face, picture);
  }

  /**
   * Shows the faces of a photo and the recent faces; hides the strip if there is nothing to choose.
   *
   * @param before latest first
   */
  async show(faces: Face[], before: Face[]) {
    const isGroup = faces.length > 1;
    this.#group.hidden = !isGroup;
    this.#previous.hidden = before.length === 0;
    this.#strip.hidden = !isGroup && before.length === 0;
    this.#before = before;
    const [latest, ...earlier] = before;
    const drawing = [this.#draw(byId("previous-thumbnail", HTMLCanvasElement), latest), ...this.#showEarlier(earlier)];
    if (faces !== this.#faces) drawing.push(...this.#showFaces(faces));
    await Promise.all(drawing);
  }

  /** @param faces of earlier photos */
  #showEarlier(faces: Face[]) {
    const buttons = faces.map((face) => {
      const button = make("button", "previous-face");
      button.type = "button";
      button.addEventListener("click", () => this.#choose(face));
      return { button, canvas: make("canvas"), face };
    });
    for (const { button, canvas } of buttons) button.append(canvas);
    this.#earlier.replaceChildren(...buttons.map(({ button }) => button));
    this.#updateLabels();
    return buttons.map(({ canvas, face }) => this.#draw(canvas, face));
  }

  /** Checks the radio button of the current face. */
  mark(shown: Face | undefined) {
    this.#shown = shown;
    for (const [index, input] of this.#inputs().entries()) {
      input.checked = this.#faces[index] === shown;
      if (input.checked) input.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }

  #showFaces(faces: Face[]) {
    this.#faces = faces;
    const options = faces.length < 2 ? [] : faces.map((face) => ({ face, canvas: make("canvas"), label: this.#option(face) }));
    for (const { label, canvas } of options) label.append(canvas);
    byId("face-options", HTMLDivElement).replaceChildren(...options.map(({ label }) => label));
    this.#updateLabels();
    this.mark(this.#shown);
    return options.map(({ canvas, face }) => this.#draw(canvas, face));
  }

  #option(face: Face) {
    const label = make("label");
    const input = make("input");
    input.type = "radio";
    input.name = "face";
    input.addEventListener("change", () => this.#choose(face));
    label.append(input);
    return label;
  }

  async #draw(canvas: HTMLCanvasElement, face: Face | undefined) {
    const thumbnail = await (face && this.#thumbnails.get(face)?.bitmap);
    if (!thumbnail) return;
    [canvas.width, canvas.height] = [thumbnail.width, thumbnail.height];
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
  }

  /** A face whose lead photo has changed gets another thumbnail. */
  #createThumbnail(face: Face, picture: ImageBitmap) {
    const lead = face.pictures[face.lead];
    if (this.#thumbnails.get(face)?.lead === lead) return;
    const { left, top, side } = boxOf(face, picture);
    const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
    const size = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: ("high" as const) };
    const bitmap = createImageBitmap(picture, left, top, side, side, size);
    bitmap.catch((error) => console.warn("cannot draw a thumbnail:", error));
    this.#thumbnails.set(face, { lead, bitmap });
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

/** Square crop around a face, in px of its picture. */
function boxOf(face: Face, { width, height }: ImageBitmap) {
  const { x, y, side: size } = faceBox(leadOf(face).landmarks, width, height);
  const side = size * (1 + 2 * MARGIN);
  return { left: Math.round(x - side / 2), top: Math.round(y - side / 2), side: Math.max(1, Math.round(side)) };
}
