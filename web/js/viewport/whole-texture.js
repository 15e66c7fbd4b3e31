import { nextTask } from "../page/tasks.js";
import { inStrips } from "../photo/open-picture.js";

/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {import("../photo/vision-client.js").VisionClient} VisionClient
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 *
 * @typedef {object} TextureRequest
 * @property {OpenedFace} face
 * @property {number} side_px
 * @property {string | undefined} lens lens assumed for the photo, which the texture depends on
 */

/**
 * Requests the whole-face texture of the open face from the worker. Until it exists, the studio shows the photo.
 */
export class WholeTexture {
  #host;
  #vision;
  #autosave;
  /** Current or failed request. @type {TextureRequest | undefined} */
  #latest;
  #onProgress;
  #hasFailed = false;
  /** @type {Promise<void>} */
  #making = Promise.resolve();

  /**
   * @param {Host} host
   * @param {VisionClient} vision
   * @param {{ face: OpenedFace | undefined }} autosave
   * @param {(isMaking: boolean) => void} onProgress
   */
  constructor(host, vision, autosave, onProgress) {
    this.#host = host;
    this.#vision = vision;
    this.#autosave = autosave;
    this.#onProgress = onProgress;
    host.onChange(() => this.#follow());
    // A restart discards the texture in transfer.
    host.onRestart(async () => {
      this.#latest = undefined;
    });
  }

  /** Resolves once the face has its texture; throws if it cannot be made. */
  async ready() {
    for (let wanted = this.#wanted(); wanted; wanted = this.#wanted()) {
      if (!isSame(wanted, this.#latest) || this.#hasFailed) this.#begin(wanted);
      await this.#making;
      // Another request may have arrived meanwhile. Repeating the same one would fail again.
      if (isSame(this.#wanted(), wanted)) throw { code: "internal", message: "the studio did not accept the texture", hint: "" };
    }
  }

  #follow() {
    const wanted = this.#wanted();
    if (wanted && !isSame(wanted, this.#latest)) this.#begin(wanted);
  }

  /** @param {TextureRequest} wanted */
  #begin(wanted) {
    this.#latest = wanted;
    this.#hasFailed = false;
    this.#onProgress(true);
    this.#making = this.#make(wanted);
    // `ready` reports errors; without a texture, the photo stays visible.
    this.#making
      .then(() => this.#complete(wanted))
      .catch(() => (this.#hasFailed = this.#latest === wanted))
      .finally(() => {
        if (this.#latest === wanted) this.#onProgress(false);
      });
  }

  /** Forgets a completed request, so that a restarted studio can request it again. @param {TextureRequest} made */
  #complete(made) {
    const isAccepted = !isSame(this.#wanted(), made);
    if (isAccepted && this.#latest === made) {
      this.#latest = undefined;
      this.#onProgress(false);
    }
  }

  /** @returns {TextureRequest | undefined} */
  #wanted() {
    const { face } = this.#autosave;
    const side_px = this.#host.ask((studio) => studio.textureWantedPx);
    if (!face || side_px === undefined) return undefined;
    return { face, side_px, lens: this.#host.ask((studio) => studio.photoLens) };
  }

  /** @param {TextureRequest} wanted */
  async #make(wanted) {
    // Draw the face first.
    await nextTask();
    const plan = this.#host.ask((studio) => studio.texturePlan());
    if (!plan) return;
    const { face, side_px } = wanted;
    // The lead photo comes first, as in the plan.
    const pictures = [face, ...(face.further ?? [])].map(pixelsOf);
    const pixels = await this.#vision.texture({ plan, pictures, side_px });
    const isWanted = () => this.#latest === wanted && isSame(this.#wanted(), wanted);
    if (!isWanted()) return;
    this.#host.attempt((studio) => studio.openTexture(side_px));
    await inStrips(this.#host, pixels, side_px, (studio, rows) => studio.addTextureRows(rows), isWanted);
  }
}

/**
 * @param {TextureRequest | undefined} one
 * @param {TextureRequest | undefined} other
 */
function isSame(one, other) {
  return one?.face === other?.face && one?.side_px === other?.side_px && one?.lens === other?.lens;
}

/** @param {OpenedFace} photo */
function pixelsOf({ picture: pixels, pictureWidth_px: width_px, pictureHeight_px: height_px }) {
  return { pixels, width_px, height_px };
}
