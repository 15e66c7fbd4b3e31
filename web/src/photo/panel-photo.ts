import type { Host } from "../viewport/host.ts";

export type Drawable = ImageBitmap | OffscreenCanvas;

/** The crop of the photo shown in the panel, with the edits. The studio draws it at the display size. */
export class PanelPhoto {
  /** The original crop. */
  #original: ImageBitmap | undefined;
  #crop = { left: 0, top: 0, width: 1, height: 1 };
  /** Photo px per px of the picture. */
  #photoPerPicture = 1;
  /** The original at the display size. */
  #unedited: ImageData | undefined;
  /** The edited crop at the display size. */
  #canvas = new OffscreenCanvas(1, 1);
  #isDirty = true;
  /** Result of the last draw. */
  #drawn: Drawable | undefined;
  /** Sizes of the photo last passed to the studio. */
  #passedKey: string | undefined;
  #host;

  constructor(host: Host) {
    this.#host = host;
  }

  /**
   * Replaces the photo.
   *
   * @param crop position of `original` in the picture
   */
  set(original: ImageBitmap, crop: { left: number; top: number; width: number; height: number; }, photoPerPicture: number) {
    this.#original = original;
    this.#crop = crop;
    this.#photoPerPicture = photoPerPicture;
    this.#passedKey = undefined;
    this.#isDirty = true;
  }

  /** Marks the photo for redrawing after a change of the edits. */
  invalidate() {
    this.#isDirty = true;
  }

  /**
   * Draws the crop with the edits; returns the original if the studio is not available.
   *
   * @param width display size in device px
   */
  drawn(width: number): Drawable | undefined {
    const original = this.#original;
    if (!original) return undefined;
    this.#passToStudio(original, Math.max(1, Math.min(Math.round(width), original.width)));
    if (this.#isDirty) this.#drawn = this.#draw() ?? original;
    this.#isDirty = false;
    return this.#drawn;
  }

  #draw() {
    const rgba = this.#host.ask((studio) => studio.panelPhoto());
    const edited = rgba && new ImageData(new Uint8ClampedArray((rgba.buffer as ArrayBuffer)), this.#canvas.width);
    const pixels = edited ?? this.#unedited;
    if (!pixels) return undefined;
    this.#canvas.getContext("2d")?.putImageData(pixels, 0, 0);
    return this.#canvas;
  }

  /** Passes the unedited pixels to the studio after a change of the photo or its size. */
  #passToStudio(original: ImageBitmap, width: number) {
    const key = `${width} ${original.width} ${original.height}`;
    if (key === this.#passedKey) return;
    this.#passedKey = key;
    this.#isDirty = true;
    const height = Math.max(1, Math.round((original.height * width) / original.width));
    Object.assign(this.#canvas, { width, height });
    const context = this.#canvas.getContext("2d", { willReadFrequently: true });
    if (!context) return;
    context.imageSmoothingQuality = "high";
    context.drawImage(original, 0, 0, width, height);
    this.#unedited = context.getImageData(0, 0, width, height);
    const rgba = new Uint8Array(this.#unedited.data.buffer);
    const { left, top } = this.#crop;
    const per = this.#photoPerPicture;
    const scale = width / (this.#crop.width * per);
    this.#host.act((studio) => studio.setPanelPhoto(rgba, width, left * per, top * per, scale));
  }
}
