/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {ImageBitmap | OffscreenCanvas} Part
 */

/**
 * The part of the photo that is shown beside the stage, with the edits in it. The studio draws it, in whatever size it is
 * shown in.
 */
export class LivePhoto {
  /** As it was taken. @type {ImageBitmap | undefined} */
  #part;
  #crop = { left: 0, top: 0, width: 1, height: 1 };
  /** How many px of the upright photo make one of the picture that the crop is of. */
  #photoPerPicture = 1;
  /** The part scaled to the requested width, without edits. @type {ImageData | undefined} */
  #unedited;
  /** The same size, with the edits where the studio has them. */
  #canvas = new OffscreenCanvas(1, 1);
  /** Whether it has changed since it was drawn. */
  #isDue = true;
  /** What was drawn last. @type {Part | undefined} */
  #drawn;
  /** Of what the studio was given. @type {string | undefined} */
  #given;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
  }

  /**
   * @param {ImageBitmap} part
   * @param {{ left: number, top: number, width: number, height: number }} crop of the picture
   * @param {number} photoPerPicture
   */
  take(part, crop, photoPerPicture) {
    this.#part = part;
    this.#crop = crop;
    this.#photoPerPicture = photoPerPicture;
    this.#given = undefined;
    this.#isDue = true;
  }

  /** The edits have changed. */
  note() {
    this.#isDue = true;
  }

  /**
   * The part with the edits; as it was taken while the studio has nothing to say.
   *
   * @param {number} width device px in which it is wanted
   * @returns {Part | undefined}
   */
  drawn(width) {
    const part = this.#part;
    if (!part) return undefined;
    const wanted = Math.max(1, Math.min(Math.round(width), part.width));
    this.#give(part, wanted);
    if (this.#isDue) this.#drawn = this.#draw() ?? part;
    this.#isDue = false;
    return this.#drawn;
  }

  #draw() {
    const rgba = this.#host.ask((studio) => studio.panelPhoto());
    const edited = rgba && new ImageData(new Uint8ClampedArray(/** @type {ArrayBuffer} */ (rgba.buffer)), this.#canvas.width);
    const pixels = edited ?? this.#unedited;
    if (!pixels) return undefined;
    this.#canvas.getContext("2d")?.putImageData(pixels, 0, 0);
    return this.#canvas;
  }

  /**
   * @param {ImageBitmap} part
   * @param {number} width
   */
  #give(part, width) {
    const key = `${width} ${part.width} ${part.height}`;
    if (key === this.#given) return;
    this.#given = key;
    this.#isDue = true;
    const height = Math.max(1, Math.round((part.height * width) / part.width));
    Object.assign(this.#canvas, { width, height });
    const context = this.#canvas.getContext("2d", { willReadFrequently: true });
    if (!context) return;
    context.imageSmoothingQuality = "high";
    context.drawImage(part, 0, 0, width, height);
    this.#unedited = context.getImageData(0, 0, width, height);
    const rgba = new Uint8Array(this.#unedited.data.buffer);
    const { left, top } = this.#crop;
    const per = this.#photoPerPicture;
    const scale = width / (this.#crop.width * per);
    this.#host.act((studio) => studio.setPanelPhoto(rgba, width, left * per, top * per, scale));
  }
}
