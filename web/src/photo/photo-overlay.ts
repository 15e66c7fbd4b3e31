import { byId } from "../page/dom.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { faceCrop } from "./face-box.ts";
import { PanelPhoto } from "./panel-photo.ts";
import { drawCircle, drawLandmarks, LANDMARK_COUNT } from "./photo-landmarks.ts";
import type { Face, PhotoView } from "../work/face.ts";
import type { Drawable } from "./panel-photo.ts";
import type { Host } from "../viewport/host.ts";
import type { Display } from "../opening.ts";

export interface Prepared {
  view: PhotoView;
  /** px */
  picture: { width: number; height: number; };
  /** in px of the picture */
  crop: { left: number; top: number; width: number; height: number; };
  /** the crop, scaled down to the largest display size */
  part: ImageBitmap;
}

/** Maximum height of the picture, in CSS px. */
const MAX_HEIGHT_PX = 320;

/** Throttle interval for redraws during an edit. */
const DRAW_EVERY_MS = 33;

/** Size of the thumbnail in the collapsed row, in CSS px. */
const THUMBNAIL_PX = 56;

/** Maximum height of the photo pane next to the stage, in CSS px. */
const MAX_PANE_PX = 720;

/** Hit radius of a landmark, in CSS px. */
const HIT_RADIUS_PX = 10;

/** The photo with the landmarks of one face, drawn on a 2D canvas. */
export class PhotoOverlay {
  #canvas = byId("photo-picture", HTMLCanvasElement);
  #part: ImageBitmap | undefined;
  #landmarks: Float32Array = new Float32Array();
  #picture = { width: 0, height: 0 };
  /** Position of `#part` in the picture, in px of the picture. */
  #crop = { left: 0, top: 0, width: 1, height: 1 };
  #size = { width_px: 0, height_px: 0 };
  #selected: number | undefined;
  #hovered: number | undefined;
  /** Draws the edited photo; undefined without a studio. */
  #edited: PanelPhoto | undefined;
  /** Positions of the points after the edits, normalised to the photo's size. */
  #moved: Float32Array | undefined;
  #timer = 0;

  constructor() {
    new ResizeObserver(() => this.#draw()).observe(byId("photo", HTMLDivElement));
    onLocaleChange(() => this.#writeCaption());
  }

  /** Shows the host's edits from now on. */
  follow(host: Host) {
    this.#edited = new PanelPhoto(host);
    byId("section-photo", HTMLDetailsElement).addEventListener("toggle", () => this.#draw());
    host.onPhoto(() => this.#drawSoon(host));
  }

  /** Adds listeners for a landmark under the pointer, a click on a landmark, and a click elsewhere on the photo. */
  listen(listener: { hover: (landmark: number | undefined) => void; choose: (landmark: number) => void; press: () => void; }) {
    this.#canvas.addEventListener("pointermove", (event) => listener.hover(this.#nearest(event)));
    this.#canvas.addEventListener("pointerleave", () => listener.hover(undefined));
    this.#canvas.addEventListener("click", (event) => {
      const landmark = this.#nearest(event);
      if (landmark === undefined) listener.press();
      else listener.choose(landmark);
    });
  }

  /** Size of the lead photo's picture, in px. */
  get pictureSize() {
    return this.#picture;
  }

  /**
   * Crops and scales a face's picture for display: uploading the full picture to the GPU would block the page.
   *
   * @param picture of its lead photo
   */
  async prepare(face: Face, picture: ImageBitmap): Promise<Display> {
    const view = leadOf(face);
    const size = { width: picture.width, height: picture.height };
    const crop = faceCrop(view.landmarks, size);
    const { left, top, width, height } = crop;
    const resizeHeight = Math.min(height, Math.round(MAX_PANE_PX * devicePixelRatio));
    const part = await createImageBitmap(picture, left, top, width, height, { resizeHeight, resizeQuality: "high" });
    return { show: () => this.#show({ view, picture: size, crop, part }), discard: () => part.close() };
  }

  #show({ view, picture, crop, part }: Prepared) {
    this.#part?.close();
    this.#part = part;
    this.#picture = picture;
    this.#landmarks = view.landmarks;
    this.#crop = crop;
    this.#moved = undefined;
    this.#edited?.set(part, crop, view.width_px / picture.width);
    this.#size = { width_px: view.width_px, height_px: view.height_px };
    byId("photo", HTMLDivElement).hidden = false;
    this.#writeCaption();
    this.#draw();
  }

  #drawThumbnail(part: Drawable) {
    const thumbnail = byId("photo-thumbnail", HTMLCanvasElement);
    const side = Math.min(part.width, part.height);
    const from = { x: (part.width - side) / 2, y: (part.height - side) / 2 };
    const context = thumbnail.getContext("2d");
    if (context) context.imageSmoothingQuality = "high";
    context?.drawImage(part, from.x, from.y, side, side, 0, 0, thumbnail.width, thumbnail.height);
  }

  /** Highlights the selected and the hovered vertex, if they are landmarks. */
  mark(selected: number | undefined, hovered: number | undefined) {
    if (selected === this.#selected && hovered === this.#hovered) return;
    this.#selected = selected;
    this.#hovered = hovered;
    this.#draw();
  }

  /** Throttled, as the user watches the stage during an edit. */
  #drawSoon(host: Host) {
    if (this.#timer !== 0) return;
    this.#timer = setTimeout(() => {
      this.#timer = 0;
      this.#moved = host.ask((studio) => studio.photoLandmarks());
      this.#edited?.invalidate();
      this.#draw();
    }, DRAW_EVERY_MS);
  }

  #draw() {
    const original = this.#part;
    if (!original) return;
    const photo = byId("photo", HTMLDivElement);
    const panel_px = photo.checkVisibility() ? photo.clientWidth : 0;
    const widest_px = Math.max(panel_px, THUMBNAIL_PX, byId("photo-pane", HTMLButtonElement).clientWidth);
    const part = this.#edited?.drawn(widest_px * devicePixelRatio) ?? original;
    this.#drawThumbnail(part);
    drawPane(part);
    if (panel_px === 0) return;
    const { width, height } = this.#crop;
    const scale = Math.min(panel_px / width, MAX_HEIGHT_PX / height);
    const ratio = devicePixelRatio;
    this.#canvas.width = Math.round(width * scale * ratio);
    this.#canvas.height = Math.round(height * scale * ratio);
    this.#canvas.style.width = `${this.#canvas.width / ratio}px`;
    const context = this.#canvas.getContext("2d");
    if (!context) return;
    context.imageSmoothingQuality = "high";
    context.drawImage(part, 0, 0, this.#canvas.width, this.#canvas.height);
    drawLandmarks(context, (landmark) => this.#positionOf(landmark), this.#landmarks.length / 3, ratio);
    for (const [landmark, radius, width] of ([[this.#hovered, 4, 1], [this.#selected, 5, 2]] as const)) {
      // Other vertices are not on the photo.
      if (landmark !== undefined && landmark < LANDMARK_COUNT) drawCircle(context, this.#positionOf(landmark), radius * ratio, width * ratio);
    }
  }

  /** Position of a landmark on the canvas, in canvas px. */
  #positionOf(landmark: number) {
    const { left, top, width, height } = this.#crop;
    const [x = 0, y = 0] = this.#moved?.subarray(2 * landmark, 2 * landmark + 2) ?? this.#landmarks.subarray(3 * landmark, 3 * landmark + 2);
    const [x_px, y_px] = [x * this.#picture.width, y * this.#picture.height];
    return { x: ((x_px - left) / width) * this.#canvas.width, y: ((y_px - top) / height) * this.#canvas.height };
  }

  #nearest(event: MouseEvent) {
    const box = this.#canvas.getBoundingClientRect();
    const ratio = this.#canvas.width / box.width;
    const x = (event.clientX - box.left) * ratio;
    const y = (event.clientY - box.top) * ratio;
    let nearest: number | undefined;
    let nearest_px = HIT_RADIUS_PX * ratio;
    for (let landmark = 0; landmark < LANDMARK_COUNT; landmark++) {
      const position = this.#positionOf(landmark);
      const distance_px = Math.hypot(position.x - x, position.y - y);
      if (distance_px < nearest_px) [nearest, nearest_px] = [landmark, distance_px];
    }
    return nearest;
  }

  #writeCaption() {
    const { width_px: width, height_px: height } = this.#size;
    byId("photo-caption", HTMLSpanElement).textContent = width > 0 ? t("photo.caption", { width, height }) : "";
  }
}

function drawPane(part: Drawable) {
  if (byId("photo-pane", HTMLButtonElement).hidden) return;
  const canvas = byId("photo-pane-canvas", HTMLCanvasElement);
  Object.assign(canvas, { width: part.width, height: part.height });
  canvas.getContext("2d")?.drawImage(part, 0, 0);
}
