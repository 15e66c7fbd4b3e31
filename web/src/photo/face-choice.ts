import { byId, make } from "../page/dom.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { faceThumbnail } from "./face-box.ts";
import { setUpStrip } from "./strip.ts";
import type { Face } from "../work/face.ts";

const THUMBNAIL_PX = 56;
/** Side of a thumbnail's crop relative to the face. */
const CROP_SCALE = 1.5;

/** Bar over the stage: a row with the faces of a photo with several faces, and a row with those of earlier photos. */
export class FaceChoice {
  #group = byId("face-choice", HTMLDivElement);
  #options = byId("face-options", HTMLDivElement);
  #earlier = byId("earlier-options", HTMLDivElement);
  /** Faces of earlier photos, latest first. */
  #before: Face[] = [];
  #faces: Face[] = [];
  /** `lead`: picture that was drawn. */
  #thumbnails: WeakMap<Face, { lead: string; bitmap: Promise<ImageBitmap> }> = new WeakMap();
  #choose;

  constructor(choose: (face: Face) => void) {
    this.#choose = choose;
    setUpStrip(this.#options);
    setUpStrip(this.#earlier);
    onLocaleChange(() => this.#updateLabels());
  }

  /** Makes the thumbnails of the faces of a photo, while its picture is available. */
  prepare(faces: Face[], picture: ImageBitmap) {
    for (const face of faces) {
      const lead = face.pictures[face.lead];
      if (this.#thumbnails.get(face)?.lead === lead) continue;
      const bitmap = faceThumbnail(picture, leadOf(face).landmarks, CROP_SCALE, THUMBNAIL_PX);
      bitmap.catch((error) => console.warn("cannot draw a thumbnail:", error));
      this.#thumbnails.set(face, { lead, bitmap });
    }
  }

  /**
   * Shows the faces of a photo and those of earlier photos; hides a row without a choice.
   *
   * @param before latest first
   */
  async show(faces: Face[], before: Face[]) {
    const isGroup = faces.length > 1;
    this.#group.hidden = !isGroup;
    byId("earlier-faces", HTMLDivElement).hidden = before.length === 0;
    byId("faces", HTMLElement).hidden = !isGroup && before.length === 0;
    const drawing: Promise<void>[] = [];
    const withThumbnail = <T extends HTMLElement>(element: T, face: Face) => {
      const canvas = make("canvas");
      drawing.push(this.#draw(canvas, face));
      element.append(canvas);
      return element;
    };
    this.#before = before;
    this.#earlier.replaceChildren(...before.map((face) => withThumbnail(this.#button(face), face)));
    if (faces !== this.#faces) {
      this.#faces = faces;
      this.#options.replaceChildren(...(isGroup ? faces.map((face) => withThumbnail(this.#option(face), face)) : []));
    }
    this.#updateLabels();
    await Promise.all(drawing);
  }

  /** Checks the radio button of the current face. */
  mark(shown: Face | undefined) {
    for (const [index, input] of this.#inputs().entries()) {
      input.checked = this.#faces[index] === shown;
      if (input.checked) input.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }

  #button(face: Face) {
    const button = make("button");
    button.type = "button";
    button.addEventListener("click", () => this.#choose(face));
    return button;
  }

  #option(face: Face) {
    const input = make("input");
    Object.assign(input, { type: "radio", name: "face" });
    input.addEventListener("change", () => this.#choose(face));
    const label = make("label");
    label.append(input);
    return label;
  }

  async #draw(canvas: HTMLCanvasElement, face: Face) {
    const thumbnail = await this.#thumbnails.get(face)?.bitmap;
    if (!thumbnail) return;
    [canvas.width, canvas.height] = [thumbnail.width, thumbnail.height];
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
  }

  #updateLabels() {
    this.#group.ariaLabel = t("face.several", { n: this.#faces.length });
    for (const [index, input] of this.#inputs().entries()) input.ariaLabel = t("face.number", { n: index + 1 });
    for (const [index, button] of this.#earlier.querySelectorAll("button").entries()) {
      button.title = button.ariaLabel = t("face.earlier", { name: this.#before[index]?.name ?? "" });
    }
  }

  #inputs() {
    return this.#options.querySelectorAll("input");
  }
}
