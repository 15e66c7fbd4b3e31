import { byId } from "../page/dom.js";
import { onLocaleChange, t } from "../words/words.js";
import { aroundFace } from "./face-box.js";
import { LivePhoto } from "./live-photo.js";
import { drawLandmarks, LANDMARK_COUNT, ring } from "./photo-landmarks.js";

/**
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 * @typedef {import("./live-photo.js").Part} Part
 *
 * @typedef {object} Prepared what is shown of a face's picture
 * @property {OpenedFace} face
 * @property {{ left: number, top: number, width: number, height: number }} crop in px of the picture
 * @property {ImageBitmap} part
 */

/** The picture is no taller than this, in CSS px. */
const MAX_HEIGHT_PX = 320;

/** While an edit goes on it is drawn this often. */
const DRAW_EVERY_MS = 33;

/** What the row shows of it while it is folded, in CSS px. */
const THUMBNAIL_PX = 56;

/** Beside the stage it is no taller than this, in CSS px. */
const MAX_BESIDE_PX = 720;

/** A pointer this near a landmark means it, in CSS px. */
const REACH_PX = 10;

/** The photo with the landmarks of one face drawn on it. Needs no WebGPU. */
export class PhotoOverlay {
  #canvas = byId("photo-picture", HTMLCanvasElement);
  /** What is shown of the picture, no larger than it can be shown. @type {ImageBitmap | undefined} */
  #part;
  /** @type {Float32Array} */
  #landmarks = new Float32Array();
  #picture = { width: 0, height: 0 };
  /** Where in the picture that part is, in its px. */
  #crop = { left: 0, top: 0, width: 1, height: 1 };
  #size = { width_px: 0, height_px: 0 };
  /** @type {number | undefined} */
  #selected;
  /** @type {number | undefined} */
  #hovered;
  /** Draws the part with the edits, once there is a studio. @type {LivePhoto | undefined} */
  #live;
  /** Where the edits have taken the points, in shares of the photo's size. @type {Float32Array | undefined} */
  #moved;
  #soon = 0;

  constructor() {
    new ResizeObserver(() => this.#draw()).observe(byId("photo", HTMLDivElement));
    onLocaleChange(() => this.#writeCaption());
  }

  /**
   * Follows the edits from now on.
   *
   * @param {import("../viewport/host.js").Host} host
   */
  follow(host) {
    this.#live = new LivePhoto(host);
    byId("section-photo", HTMLDetailsElement).addEventListener("toggle", () => this.#draw());
    host.onPhoto(() => this.#drawSoon(host));
  }

  /**
   * Tells which landmark the pointer is over, which one is clicked, and that the photo itself is.
   *
   * @param {{ hover: (landmark: number | undefined) => void, choose: (landmark: number) => void, press: () => void }} told
   */
  listen(told) {
    this.#canvas.addEventListener("pointermove", (event) => told.hover(this.#nearest(event)));
    this.#canvas.addEventListener("pointerleave", () => told.hover(undefined));
    this.#canvas.addEventListener("click", (event) => {
      const landmark = this.#nearest(event);
      if (landmark === undefined) told.press();
      else told.choose(landmark);
    });
  }

  /**
   * Gets ready what is shown of a face's picture. Only that is kept, and drawn: the whole picture would hold the page up on its
   * way to the GPU.
   *
   * @param {OpenedFace} face
   * @param {ImageBitmap} picture
   * @returns {Promise<Prepared>}
   */
  async prepare(face, picture) {
    const crop = aroundFace(face.landmarks, picture);
    const { left, top, width, height } = crop;
    const resizeHeight = Math.min(height, Math.round(MAX_BESIDE_PX * devicePixelRatio));
    const part = await createImageBitmap(picture, left, top, width, height, { resizeHeight, resizeQuality: "high" });
    return { face, crop, part };
  }

  /**
   * Shows the picture and the landmarks of one of its faces.
   *
   * @param {Prepared} prepared
   */
  show({ face, crop, part }) {
    this.#part?.close();
    this.#part = part;
    this.#picture = { width: face.pictureWidth_px, height: face.pictureHeight_px };
    this.#landmarks = face.landmarks;
    this.#crop = crop;
    this.#moved = undefined;
    this.#live?.take(part, crop, face.width_px / face.pictureWidth_px);
    this.#size = { width_px: face.width_px, height_px: face.height_px };
    byId("photo", HTMLDivElement).hidden = false;
    this.#writeCaption();
    this.#draw();
  }

  /** @param {Part} part */
  #drawThumbnail(part) {
    const thumbnail = byId("photo-thumbnail", HTMLCanvasElement);
    const side = Math.min(part.width, part.height);
    const from = { x: (part.width - side) / 2, y: (part.height - side) / 2 };
    const context = thumbnail.getContext("2d");
    if (context) context.imageSmoothingQuality = "high";
    context?.drawImage(part, from.x, from.y, side, side, 0, 0, thumbnail.width, thumbnail.height);
  }

  /**
   * Marks the landmark being edited and the one under the pointer, if they are landmarks.
   *
   * @param {number | undefined} selected
   * @param {number | undefined} hovered
   */
  mark(selected, hovered) {
    if (selected === this.#selected && hovered === this.#hovered) return;
    this.#selected = selected;
    this.#hovered = hovered;
    this.#draw();
  }

  /**
   * Not oftener than the eye sees beside what is being done on the stage.
   *
   * @param {import("../viewport/host.js").Host} host
   */
  #drawSoon(host) {
    if (this.#soon !== 0) return;
    this.#soon = setTimeout(() => {
      this.#soon = 0;
      this.#moved = host.ask((studio) => studio.photoLandmarks());
      this.#live?.note();
      this.#draw();
    }, DRAW_EVERY_MS);
  }

  #draw() {
    const taken = this.#part;
    if (!taken) return;
    const photo = byId("photo", HTMLDivElement);
    const room_px = photo.checkVisibility() ? photo.clientWidth : 0;
    const widest_px = Math.max(room_px, THUMBNAIL_PX, byId("photo-pane", HTMLButtonElement).clientWidth);
    const part = this.#live?.drawn(widest_px * devicePixelRatio) ?? taken;
    this.#drawThumbnail(part);
    drawBeside(part);
    if (room_px === 0) return;
    const { width, height } = this.#crop;
    const scale = Math.min(room_px / width, MAX_HEIGHT_PX / height);
    const ratio = devicePixelRatio;
    this.#canvas.width = Math.round(width * scale * ratio);
    this.#canvas.height = Math.round(height * scale * ratio);
    this.#canvas.style.width = `${this.#canvas.width / ratio}px`;
    const context = this.#canvas.getContext("2d");
    if (!context) return;
    context.imageSmoothingQuality = "high";
    context.drawImage(part, 0, 0, this.#canvas.width, this.#canvas.height);
    drawLandmarks(context, (landmark) => this.#place(landmark), this.#landmarks.length / 3, ratio);
    for (const [landmark, radius, width] of /** @type {const} */ ([[this.#hovered, 4, 1], [this.#selected, 5, 2]])) {
      // Only landmarks are on the photo.
      if (landmark !== undefined && landmark < LANDMARK_COUNT) ring(context, this.#place(landmark), radius * ratio, width * ratio);
    }
  }

  /**
   * Where a landmark lies on the canvas, in its own px.
   *
   * @param {number} landmark
   */
  #place(landmark) {
    const { left, top, width, height } = this.#crop;
    const [x_share = 0, y_share = 0] = this.#moved?.subarray(2 * landmark, 2 * landmark + 2) ?? this.#landmarks.subarray(3 * landmark, 3 * landmark + 2);
    const [x_px, y_px] = [x_share * this.#picture.width, y_share * this.#picture.height];
    return { x: ((x_px - left) / width) * this.#canvas.width, y: ((y_px - top) / height) * this.#canvas.height };
  }

  /** @param {MouseEvent} event */
  #nearest(event) {
    const box = this.#canvas.getBoundingClientRect();
    const ratio = this.#canvas.width / box.width;
    const x = (event.clientX - box.left) * ratio;
    const y = (event.clientY - box.top) * ratio;
    let nearest;
    let nearest_px = REACH_PX * ratio;
    for (let landmark = 0; landmark < LANDMARK_COUNT; landmark++) {
      const place = this.#place(landmark);
      const distance_px = Math.hypot(place.x - x, place.y - y);
      if (distance_px < nearest_px) [nearest, nearest_px] = [landmark, distance_px];
    }
    return nearest;
  }

  #writeCaption() {
    const { width_px: width, height_px: height } = this.#size;
    byId("photo-caption", HTMLSpanElement).textContent = width > 0 ? t("photo.caption", { width, height }) : "";
  }
}

/** @param {Part} part */
function drawBeside(part) {
  if (byId("photo-pane", HTMLButtonElement).hidden) return;
  const canvas = byId("photo-pane-canvas", HTMLCanvasElement);
  Object.assign(canvas, { width: part.width, height: part.height });
  canvas.getContext("2d")?.drawImage(part, 0, 0);
}
