import { byId, make, makeIcon } from "../page/dom.js";
import { toast } from "../page/toast.js";
import { faceBox } from "../photo/face-box.js";
import { onLocaleChange, t } from "../words/words.js";
import { photoFacts, photosOf, indexOfPhoto } from "../work/photos.js";
import { imageDataOf } from "../work/pixels.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 * @typedef {ReturnType<typeof photoFacts>[number]} Facts
 *
 * @typedef {object} Photos
 * @property {OpenedFace | undefined} face open face
 * @property {(files: File[]) => Promise<void>} addPhotos
 * @property {(photo: OpenedFace) => Promise<void>} removePhoto
 * @property {(photo: OpenedFace) => Promise<void>} restorePhoto
 */

const THUMBNAIL_PX = 40;
/** Side of the thumbnail's crop, as a multiple of the face's size. */
const AROUND_FACE = 1.4;

/** Lists the photos of the open face, reports missing head turns, and adds or removes photos. */
export class PhotosPanel {
  #host;
  #opening;
  #list = byId("photo-list", HTMLUListElement);
  #missingLine = byId("photos-missing", HTMLParagraphElement);
  #add = byId("add-photo", HTMLButtonElement);
  #restore = byId("photo-removed", HTMLDivElement);
  /** Face whose rows are shown. @type {OpenedFace | undefined} */
  #face;
  /**
   * Last removed photo and the face without it. It can be restored while that face is open.
   *
   * @type {{ photo: OpenedFace, face: OpenedFace } | undefined}
   */
  #removed;

  /**
   * @param {Host} host
   * @param {() => Photos} opening
   */
  constructor(host, opening) {
    this.#host = host;
    this.#opening = opening;
    this.#setUpChooser();
    byId("restore-photo", HTMLButtonElement).addEventListener("click", () => this.#restorePhoto());
    host.onChange(() => this.#show());
    onLocaleChange(() => this.#show());
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

  /** @param {(opening: Photos) => Promise<void>} act */
  async #change(act) {
    const before = this.#count();
    await act(this.#opening());
    const n = this.#count();
    if (n !== before) toast(n > 1 ? t("photos.added", { n }) : t("photos.alone"));
  }

  /** @param {OpenedFace} photo */
  async #remove(photo) {
    await this.#change((opening) => opening.removePhoto(photo));
    const { face } = this.#opening();
    if (!face || indexOfPhoto(face, photo) !== undefined) return;
    this.#removed = { photo, face };
    this.#show();
  }

  async #restorePhoto() {
    const { photo } = this.#removed ?? {};
    if (photo) await this.#change((opening) => opening.restorePhoto(photo));
  }

  #count() {
    const { face } = this.#opening();
    return face ? photosOf(face).length : 0;
  }

  #show() {
    const { face } = this.#opening();
    const facts = this.#host.ask(photoFacts) ?? [];
    const photos = face ? photosOf(face) : [];
    this.#missingLine.textContent = (this.#host.ask((studio) => studio.missingTurns()) ?? []).map(missingText).join(" ");
    this.#missingLine.hidden = this.#list.hidden = facts.length < 2;
    this.#add.disabled = facts.length >= (this.#host.ask((studio) => studio.maxPhotos) ?? 0);
    if (photos.length !== facts.length) return;
    const hadFocus = this.#list.contains(document.activeElement);
    if (face !== this.#face) this.#list.replaceChildren(...(photos.length < 2 ? [] : photos.map((photo) => this.#row(photo))));
    this.#face = face;
    // Moves the focus if its button was removed.
    if (hadFocus && !this.#list.contains(document.activeElement)) this.#add.focus();
    const restoreHadFocus = this.#restore.contains(document.activeElement);
    this.#restore.hidden = this.#removed?.face !== face;
    if (restoreHadFocus && this.#restore.hidden) this.#add.focus();
    for (const [place, row] of [...this.#list.children].entries()) write(row, facts[place]);
  }

  /** @param {OpenedFace} photo */
  #row(photo) {
    const row = make("li");
    const canvas = make("canvas");
    canvas.setAttribute("aria-hidden", "true");
    draw(canvas, photo).catch((error) => console.warn("cannot draw a thumbnail:", error));
    const remove = make("button", "icon-button");
    remove.type = "button";
    remove.append(makeIcon("close"));
    // A double click would also remove the photo that moves into this row.
    remove.addEventListener("click", ({ detail }) => detail < 2 && this.#remove(photo));
    row.append(canvas, make("span"), remove);
    return row;
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

/**
 * @param {HTMLCanvasElement} canvas
 * @param {OpenedFace} photo
 */
async function draw(canvas, photo) {
  const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
  const { x, y, side: size } = faceBox(photo.landmarks, photo.pictureWidth_px, photo.pictureHeight_px);
  const side = Math.max(1, Math.round(AROUND_FACE * size));
  const place = [Math.round(x - side / 2), Math.round(y - side / 2)];
  const resize = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: /** @type {const} */ ("high") };
  const bitmap = await createImageBitmap(imageDataOf(photo), place[0] ?? 0, place[1] ?? 0, side, side, resize);
  [canvas.width, canvas.height] = [side_px, side_px];
  canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
  bitmap.close();
}
