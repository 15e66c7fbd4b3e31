import { byId, make, makeIcon } from "../../src/dom.ts";
import { toast } from "../page/toast.js";
import { faceBox } from "../photo/face-box.js";
import { onLocaleChange, t } from "../words/words.js";
import { photoOf, viewsOf } from "../work/face.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").State} State
 * @typedef {import("../opening.js").Opening} Opening
 * @typedef {import("../photo/vision-client.js").VisionClient} VisionClient
 * @typedef {import("../work/face.js").Face} Face
 * @typedef {import("../work/face.js").FacePhoto} FacePhoto
 * @typedef {State["photos"][number]} Facts
 */

const THUMBNAIL_PX = 40;
/** Side of the thumbnail's crop, as a multiple of the face's size. */
const AROUND_FACE = 1.4;

/** Lists the photos of the open face, reports missing head turns, and adds or removes photos. */
export class PhotosPanel {
  #host;
  #opening;
  #vision;
  #list = byId("photo-list", HTMLUListElement);
  #missingLine = byId("photos-missing", HTMLParagraphElement);
  #add = byId("add-photo", HTMLButtonElement);
  #restore = byId("photo-removed", HTMLDivElement);
  /** Pictures whose rows are shown. */
  #shown = "";
  /**
   * Last removed photo, and the face and its pictures without it. It can be restored while these are open.
   *
   * @type {{ photo: FacePhoto, face: Face, pictures: string } | undefined}
   */
  #removed;

  /**
   * @param {Host} host
   * @param {Opening} opening
   * @param {VisionClient} vision
   */
  constructor(host, opening, vision) {
    this.#host = host;
    this.#opening = opening;
    this.#vision = vision;
    this.#setUpChooser();
    byId("restore-photo", HTMLButtonElement).addEventListener("click", () => this.#restorePhoto());
    host.onChange((state) => this.#show(state));
    onLocaleChange(() => this.#host.read((state) => this.#show(state)));
  }

  #setUpChooser() {
    const input = byId("further-files", HTMLInputElement);
    this.#add.addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      const files = [...(input.files ?? [])];
      // Clears the input: choosing the same file twice would fire no change event.
      input.value = "";
      if (files.length > 0) this.#change((opening) => opening.addPhotos(files));
    });
  }

  /** @param {(opening: Opening) => Promise<void>} act */
  async #change(act) {
    const before = this.#count();
    await act(this.#opening);
    const n = this.#count();
    if (n !== before) toast(n > 1 ? t("photos.added", { n }) : t("photos.alone"));
  }

  /** @param {string} picture */
  async #remove(picture) {
    const { face } = this.#opening;
    if (!face?.pictures.includes(picture)) return;
    const photo = photoOf(face, picture);
    await this.#change((opening) => opening.removePhoto(picture));
    if (this.#opening.face !== face || face.pictures.includes(picture)) return;
    this.#removed = { photo, face, pictures: face.pictures.join() };
    this.#host.read((state) => this.#show(state));
  }

  async #restorePhoto() {
    const { photo } = this.#removed ?? {};
    if (photo) await this.#change((opening) => opening.restorePhoto(photo));
  }

  #count() {
    return this.#opening.face?.pictures.length ?? 0;
  }

  /** @param {State} state */
  #show({ photos: facts, missingTurns }) {
    const { face } = this.#opening;
    const pictures = face?.pictures ?? [];
    this.#missingLine.textContent = missingTurns.map(missingText).join(" ");
    this.#missingLine.hidden = this.#list.hidden = facts.length < 2;
    this.#add.disabled = facts.length >= this.#host.catalogue.maxPhotos;
    if (pictures.length !== facts.length) return;
    const hadFocus = this.#list.contains(document.activeElement);
    if (pictures.join() !== this.#shown) this.#list.replaceChildren(...(face && pictures.length > 1 ? this.#rows(face) : []));
    this.#shown = pictures.join();
    // Moves the focus if its button was removed.
    if (hadFocus && !this.#list.contains(document.activeElement)) this.#add.focus();
    const restoreHadFocus = this.#restore.contains(document.activeElement);
    this.#restore.hidden = this.#removed?.face !== face || this.#removed?.pictures !== this.#shown;
    if (restoreHadFocus && this.#restore.hidden) this.#add.focus();
    for (const [place, row] of [...this.#list.children].entries()) write(row, facts[place]);
  }

  /** @param {Face} face */
  #rows(face) {
    return face.pictures.map((picture) => {
      const row = make("li");
      const canvas = make("canvas");
      canvas.setAttribute("aria-hidden", "true");
      this.#draw(canvas, photoOf(face, picture)).catch((error) => console.warn("cannot draw a thumbnail:", error));
      const remove = make("button", "icon-button");
      remove.type = "button";
      remove.append(makeIcon("close"));
      // A double click would also remove the photo that moves into this row.
      remove.addEventListener("click", ({ detail }) => detail < 2 && this.#remove(picture));
      row.append(canvas, make("span"), remove);
      return row;
    });
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {FacePhoto} photo
   */
  async #draw(canvas, photo) {
    const thumbnail = await this.#thumbnail(photo);
    [canvas.width, canvas.height] = [thumbnail.width, thumbnail.height];
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
    thumbnail.close();
  }

  /** @param {FacePhoto} photo */
  async #thumbnail({ photos, pictures: [picture = ""], files }) {
    const [{ landmarks } = { landmarks: new Float32Array() }] = viewsOf(photos);
    const whole = await this.#vision.picture(picture, files);
    const { x, y, side: size } = faceBox(landmarks, whole.width, whole.height);
    const side = Math.max(1, Math.round(AROUND_FACE * size));
    const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
    const resize = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: /** @type {const} */ ("high") };
    const thumbnail = createImageBitmap(whole, Math.round(x - side / 2), Math.round(y - side / 2), side, side, resize);
    return thumbnail.finally(() => whole.close());
  }
}

/**
 * @param {Element} row
 * @param {Facts | undefined} facts
 */
function write(row, facts) {
  const [span, button] = [row.querySelector("span"), row.querySelector("button")];
  if (!facts || !span || !button) return;
  const turn = turnText(facts);
  span.textContent = facts.leads ? t("photos.leads", { turn }) : turn;
  const words = t("photos.remove", { turn });
  button.setAttribute("aria-label", words);
  button.title = words;
}

/** @param {Facts} facts */
function turnText({ turn, yawDeg }) {
  const degrees = Math.round(Math.abs(yawDeg));
  if (turn === "front") return t("photos.turn.front");
  return t(yawDeg > 0 ? "photos.turn.left" : "photos.turn.right", { degrees });
}

/** @param {string} turn head turn that no photo shows */
function missingText(turn) {
  if (turn === "front") return t("photos.missing.front");
  return t(turn === "left" ? "photos.missing.left" : "photos.missing.right");
}
