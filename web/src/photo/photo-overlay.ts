import { byId } from "../page/dom.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { leadOf } from "../work/face.ts";
import { faceCrop } from "./face-box.ts";
import { drawCircle, drawLandmarks, fill, LANDMARK_COUNT } from "./photo-drawing.ts";
import type { Face, PhotoView } from "../work/face.ts";
import type { Drawable, Place } from "./photo-drawing.ts";
import type { Host } from "../viewport/host.ts";
import type { Display } from "../opening.ts";

interface Shown {
  view: PhotoView;
  /** px */
  picture: { width: number; height: number };
  /** in px of the picture */
  crop: ReturnType<typeof faceCrop>;
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
  #photo = byId("photo", HTMLDivElement);
  #host: Host | undefined;
  #shown: Shown | undefined;
  #selected: number | undefined;
  #hovered: number | undefined;
  /** Positions of the points after the edits, normalised to the photo's size. */
  #moved: Float32Array | undefined;
  /** The crop at its display size: without edits, as the studio got it, and drawn with them. */
  #panel: { part: ImageBitmap; unedited: ImageData; canvas: OffscreenCanvas } | undefined;
  /** Whether the edits have changed since the crop was drawn. */
  #isChanged = true;
  /** Positions of the points on the canvas, in canvas px. */
  #places: Place[] = [];
  #timer = 0;

  constructor() {
    new ResizeObserver(() => this.#draw()).observe(this.#photo);
    onLocaleChange(() => this.#writeCaption());
  }

  /** Shows the host's edits from now on. */
  follow(host: Host) {
    this.#host = host;
    byId("section-photo", HTMLDetailsElement).addEventListener("toggle", () => this.#draw());
    this.#canvas.addEventListener("click", (event) => {
      const landmark = this.#nearest(event);
      host.apply(landmark === undefined ? { scene: "picture" } : { "select-at": landmark });
    });
    host.on("photo", () => this.#drawSoon(host));
  }

  /** @param listener called with the landmark under the pointer */
  onHover(listener: (landmark: number | undefined) => void) {
    this.#canvas.addEventListener("pointermove", (event) => listener(this.#nearest(event)));
    this.#canvas.addEventListener("pointerleave", () => listener(undefined));
  }

  /** Size of the lead photo's picture, in px. */
  get pictureSize() {
    return this.#shown?.picture ?? { width: 0, height: 0 };
  }

  /**
   * Crops and scales a face's picture for display: uploading the full picture to the GPU would block the page.
   *
   * @param picture of its lead photo
   */
  async prepare(face: Face, picture: ImageBitmap): Promise<Display> {
    const view = leadOf(face);
    const crop = faceCrop(view.landmarks, picture);
    const { left, top, width, height } = crop;
    const resizeHeight = Math.min(height, Math.round(MAX_PANE_PX * devicePixelRatio));
    const size = { width: picture.width, height: picture.height };
    const part = await createImageBitmap(picture, left, top, width, height, { resizeHeight, resizeQuality: "high" });
    return { show: () => this.#show({ view, picture: size, crop, part }), discard: () => part.close() };
  }

  #show(shown: Shown) {
    this.#shown?.part.close();
    this.#shown = shown;
    this.#moved = undefined;
    this.#photo.hidden = false;
    this.#writeCaption();
    this.#draw();
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
      this.#isChanged = true;
      this.#draw();
    }, DRAW_EVERY_MS);
  }

  #draw() {
    const shown = this.#shown;
    if (!shown) return;
    const ratio = devicePixelRatio;
    const pane = byId("photo-pane", HTMLButtonElement);
    const panel_px = this.#photo.checkVisibility() ? this.#photo.clientWidth : 0;
    const part = this.#edited(shown, ratio * Math.max(panel_px, THUMBNAIL_PX, pane.clientWidth));
    const side = Math.min(part.width, part.height);
    fill(byId("photo-thumbnail", HTMLCanvasElement), part, side, side);
    if (!pane.hidden) {
      const canvas = byId("photo-pane-canvas", HTMLCanvasElement);
      Object.assign(canvas, { width: part.width, height: part.height });
      fill(canvas, part);
    }
    if (panel_px === 0) return;
    const { width, height } = shown.crop;
    const scale = ratio * Math.min(panel_px / width, MAX_HEIGHT_PX / height);
    Object.assign(this.#canvas, { width: Math.round(width * scale), height: Math.round(height * scale) });
    this.#canvas.style.width = `${this.#canvas.width / ratio}px`;
    const context = fill(this.#canvas, part);
    this.#places = this.#placesOf(shown);
    drawLandmarks(context, this.#places, ratio);
    context.strokeStyle = getComputedStyle(this.#canvas).color;
    for (const [landmark, radius, width] of [[this.#hovered, 4, 1], [this.#selected, 5, 2]] as const) {
      // Other vertices are not on the photo.
      if (landmark === undefined || landmark >= LANDMARK_COUNT) continue;
      context.lineWidth = width * ratio;
      drawCircle(context, this.#places[landmark], radius * ratio);
    }
  }

  /**
   * The crop with the edits; without them if the studio is not available.
   *
   * @param width_px display size, in device px
   */
  #edited({ view, picture, crop, part }: Shown, width_px: number): Drawable {
    const host = this.#host;
    if (!host) return part;
    const width = Math.max(1, Math.min(Math.round(width_px), part.width));
    if (this.#panel?.part !== part || this.#panel.canvas.width !== width) {
      const canvas = new OffscreenCanvas(width, Math.max(1, Math.round((part.height * width) / part.width)));
      canvas.getContext("2d", { willReadFrequently: true });
      const unedited = fill(canvas, part).getImageData(0, 0, width, canvas.height);
      this.#panel = { part, unedited, canvas };
      this.#isChanged = true;
      const rgba = new Uint8Array(unedited.data.buffer);
      const perPicture = view.width_px / picture.width;
      const [left, top, scale] = [crop.left * perPicture, crop.top * perPicture, width / (crop.width * perPicture)];
      host.act((studio) => studio.setPanelPhoto(rgba, width, left, top, scale));
    }
    const { canvas, unedited } = this.#panel;
    if (this.#isChanged) {
      const rgba = host.ask((studio) => studio.panelPhoto());
      const edited = rgba && new ImageData(new Uint8ClampedArray(rgba.buffer as ArrayBuffer), width);
      canvas.getContext("2d")?.putImageData(edited ?? unedited, 0, 0);
    }
    this.#isChanged = false;
    return canvas;
  }

  #placesOf({ view, picture, crop }: Shown): Place[] {
    const { width, height } = this.#canvas;
    return Array.from({ length: view.landmarks.length / 3 }, (_, point) => {
      const moved = this.#moved?.subarray(2 * point, 2 * point + 2);
      const [x = 0, y = 0] = moved ?? view.landmarks.subarray(3 * point, 3 * point + 2);
      return {
        x: ((x * picture.width - crop.left) / crop.width) * width,
        y: ((y * picture.height - crop.top) / crop.height) * height,
      };
    });
  }

  #nearest({ offsetX, offsetY }: MouseEvent) {
    const ratio = this.#canvas.width / this.#canvas.clientWidth;
    const landmarks = this.#places.slice(0, LANDMARK_COUNT);
    const distances_px = landmarks.map(({ x, y }) => Math.hypot(x - offsetX * ratio, y - offsetY * ratio));
    const least_px = Math.min(...distances_px);
    return least_px < HIT_RADIUS_PX * ratio ? distances_px.indexOf(least_px) : undefined;
  }

  #writeCaption() {
    const { width_px: width, height_px: height } = this.#shown?.view ?? {};
    const caption = width && height ? t("photo.caption", { width, height }) : "";
    byId("photo-caption", HTMLSpanElement).textContent = caption;
  }
}
