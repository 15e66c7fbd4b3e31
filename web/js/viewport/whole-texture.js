import { nextTask } from "../page/tasks.js";
import { inStrips } from "../photo/open-picture.js";

/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {import("../photo/vision-client.js").VisionClient} VisionClient
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 *
 * @typedef {object} Wanted
 * @property {OpenedFace} face
 * @property {number} side_px
 * @property {string | undefined} lens through which the photo is taken to be taken: the texture depends on it
 */

/**
 * Sees to it that the face that is open has its texture: the worker makes it, and until it is there the photo is what is
 * seen. Without a worker it stays so.
 */
export class WholeTexture {
  #host;
  #vision;
  #autosave;
  /** @type {Wanted | undefined} what is being made, or could not be */
  #latest;
  #tell;
  #hasFailed = false;
  /** @type {Promise<void>} */
  #making = Promise.resolve();

  /**
   * @param {Host} host
   * @param {VisionClient} vision
   * @param {{ face: OpenedFace | undefined }} autosave
   * @param {(isMaking: boolean) => void} tell
   */
  constructor(host, vision, autosave, tell) {
    this.#host = host;
    this.#vision = vision;
    this.#autosave = autosave;
    this.#tell = tell;
    host.onChange(() => this.#follow());
    // What was on its way to the studio before is lost with it.
    host.onRestart(async () => {
      this.#latest = undefined;
    });
  }

  /** Resolves once the face has its texture, and throws what stands in its way. */
  async ready() {
    for (let wanted = this.#wanted(); wanted; wanted = this.#wanted()) {
      if (!isSame(wanted, this.#latest) || this.#hasFailed) this.#begin(wanted);
      await this.#making;
      // Another one may be wanted by now; the same one once more could be made no better.
      if (isSame(this.#wanted(), wanted)) throw { code: "internal", message: "the texture was not taken", hint: "" };
    }
  }

  #follow() {
    const wanted = this.#wanted();
    if (wanted && !isSame(wanted, this.#latest)) this.#begin(wanted);
  }

  /** @param {Wanted} wanted */
  #begin(wanted) {
    this.#latest = wanted;
    this.#hasFailed = false;
    this.#tell(true);
    this.#making = this.#make(wanted);
    // Whoever needs it hears of it; who does not, sees the photo.
    this.#making
      .then(() => this.#settle(wanted))
      .catch(() => (this.#hasFailed = this.#latest === wanted))
      .finally(() => {
        if (this.#latest === wanted) this.#tell(false);
      });
  }

  /**
   * What was taken is nobody's concern any more: a studio that is started again wants the same once more.
   *
   * @param {Wanted} made
   */
  #settle(made) {
    const isTaken = !isSame(this.#wanted(), made);
    if (isTaken && this.#latest === made) {
      this.#latest = undefined;
      this.#tell(false);
    }
  }

  /** @returns {Wanted | undefined} */
  #wanted() {
    const { face } = this.#autosave;
    const side_px = this.#host.ask((studio) => studio.textureWantedPx);
    if (!face || side_px === undefined) return undefined;
    return { face, side_px, lens: this.#host.ask((studio) => studio.photoLens) };
  }

  /** @param {Wanted} wanted */
  async #make(wanted) {
    // The face is on the screen first.
    await nextTask();
    const plan = this.#host.ask((studio) => studio.texturePlan());
    if (!plan) return;
    const { face, side_px } = wanted;
    // The one that leads first, as in the plan.
    const pictures = [face, ...(face.further ?? [])].map(pixelsOf);
    const pixels = await this.#vision.texture({ plan, pictures, side_px });
    const isWanted = () => this.#latest === wanted && isSame(this.#wanted(), wanted);
    if (!isWanted()) return;
    this.#host.attempt((studio) => studio.openTexture(side_px));
    await inStrips(this.#host, pixels, side_px, (studio, rows) => studio.addTextureRows(rows), isWanted);
  }
}

/**
 * @param {Wanted | undefined} one
 * @param {Wanted | undefined} other
 */
function isSame(one, other) {
  return one?.face === other?.face && one?.side_px === other?.side_px && one?.lens === other?.lens;
}

/** @param {OpenedFace} photo */
function pixelsOf({ picture: pixels, pictureWidth_px: width_px, pictureHeight_px: height_px }) {
  return { pixels, width_px, height_px };
}
