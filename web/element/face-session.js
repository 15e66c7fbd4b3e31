import { make } from "../js/page/dom.js";
import { Replaced } from "../js/photo/vision-client.js";
import { openPictures, takeFace } from "../js/photo/open-picture.js";
import { Host } from "../js/viewport/host.js";
import { LandmarkMarks } from "../js/viewport/landmark-marks.js";
import { isTrap } from "../js/viewport/studio-module.js";
import { setUpViewKeys } from "../js/viewport/shortcuts.js";
import { WholeTexture } from "../js/viewport/whole-texture.js";
import { stemOf } from "../js/work/file-name.js";
import { photosOf } from "../js/work/photos.js";
import { kindOf, readSavedFile } from "../js/work/saved-file.js";
import { standing } from "../js/work/standing.js";
import { loadWords } from "../js/words/words.js";
import { writtenFile } from "../js/work/written-file.js";
import { borrowVision, facesIn, returnVision } from "./shared-vision.js";

/**
 * @typedef {import("../js/work/work.js").OpenedFace} OpenedFace
 * @typedef {import("../js/work/work.js").Done} Done
 * @typedef {import("../js/worker/protocol.js").Stage} Stage
 *
 * @typedef {object} Told what is told of the session
 * @property {(stage: Stage | "loading", fraction: number) => void} progress
 * @property {() => void} face another face is shown
 * @property {() => void} change its edits are others
 * @property {() => void} announce anything about it is another
 * @property {(thrown: unknown, owner: string) => void} error that nobody waits for, and whose it is
 * @property {(owner: string) => void} settled what was told as that owner's error is over
 */

/** @type {Told} */
const UNHEARD = { progress: () => {}, face: () => {}, change: () => {}, announce: () => {}, error: (thrown) => console.error(thrown), settled: () => {} };

/** A face on a canvas, with the hand's gestures and keys: what the page has of it, without the page. */
export class FaceSession {
  /** Photos are brought in one after the other: each takes several tasks. @type {Promise<unknown>} */
  #last = Promise.resolve();
  #newest = 0;
  #told;
  #texture;
  /** @type {OpenedFace | undefined} */
  #face;
  /** @type {OpenedFace[]} */
  #faces = [];
  /** @type {Done | undefined} */
  #done;
  #isTaking = false;

  /**
   * Opens a session on a canvas that was never drawn on; throws `{code: "no-webgl", …}` where the browser cannot draw in 3D.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Partial<Told>} [told]
   * @param {HTMLOutputElement} [tag] beside the canvas, for names of landmarks
   */
  static async open(canvas, told = {}, tag = make("output")) {
    const all = { ...UNHEARD, ...told };
    await loadWords(navigator.language);
    return new FaceSession(await Host.open(canvas, { show: all.error, hide: all.settled }), tag, all);
  }

  /**
   * @param {Host} host
   * @param {HTMLOutputElement} tag
   * @param {Told} told
   */
  constructor(host, tag, told) {
    this.host = host;
    this.#told = told;
    new LandmarkMarks(host, { tag });
    setUpViewKeys(host);
    this.#texture = new WholeTexture(host, borrowVision(), this, () => {});
    host.onChange(() => this.#follow());
    host.onRestart(() => this.#workAgain());
  }

  /** The face that is shown. */
  get face() {
    return this.#face;
  }

  /** All faces of its photo, the most prominent first. */
  get faces() {
    return this.#faces;
  }

  /**
   * Shows the face of a photo, or of a GLB or project that was saved. A newer one replaces an older, which is then rejected
   * with `Replaced`.
   *
   * @param {Blob} file
   */
  async open(file) {
    const isWanted = this.#ticket();
    const kind = await kindOf(file);
    if (kind === "other") {
      const faces = await facesIn(file, stemOf(file), this.#told.progress, isWanted);
      return this.#show(faces, 0, undefined, isWanted);
    }
    const { face, changedElsewhere: _, ...done } = await readSavedFile(file, kind);
    return this.#show([face], 0, done, isWanted);
  }

  /**
   * Shows another face of the same photo.
   *
   * @param {number} index
   */
  openFace(index) {
    return this.#show(this.#faces, index, undefined, this.#ticket());
  }

  /**
   * Carries an intent out; what goes wrong is thrown.
   *
   * @param {(studio: import("../js/viewport/host.js").Studio) => import("../js/viewport/host.js").ChangeName | void} intent
   */
  apply(intent) {
    return this.#watched(() => this.host.attempt(intent));
  }

  /**
   * The face as a file.
   *
   * @param {string} format such as "glb"
   * @param {import("../js/work/written-file.js").Chosen} chosen
   */
  async file(format, chosen) {
    if (!this.#face) throw { code: "no-face", message: "no face is open", hint: "" };
    const written = writtenFile(this.host, this.#texture, format, { "base-colour": "whole", ...chosen });
    const bytes = await written.catch((error) => this.#mind(error));
    return new Blob([/** @type {BlobPart} */ (bytes)], { type: this.host.answer((studio) => studio.mediaType(format)) });
  }

  /** Gives everything back. */
  close() {
    this.#newest += 1;
    this.host.close();
    returnVision();
  }

  #ticket() {
    const ticket = ++this.#newest;
    return () => ticket === this.#newest;
  }

  /**
   * @param {OpenedFace[]} faces
   * @param {number} index
   * @param {Done | undefined} done
   * @param {() => boolean} isWanted
   */
  async #show(faces, index, done, isWanted) {
    const face = faces[index];
    if (!face) throw { code: "bad-number", message: `face ${index} of ${faces.length}`, hint: "" };
    const shown = this.#last.then(() => this.#bringIn(face, done, isWanted));
    this.#last = shown.catch(() => {});
    await shown;
    this.#faces = faces;
    this.#told.face();
    this.host.announce();
  }

  /**
   * @param {OpenedFace} face
   * @param {Done | undefined} done
   * @param {() => boolean} isWanted
   */
  async #bringIn(face, done, isWanted) {
    const photos = photosOf({ ...face, lens: done?.lens ?? face.lens });
    if (!isWanted() || !(await openPictures(this.host, photos, isWanted))) throw new Replaced();
    this.#isTaking = true;
    try {
      this.#watched(() => takeFace(this.host, photos, done));
      this.#face = face;
    } finally {
      this.#isTaking = false;
    }
    this.#done = standing(this.host);
  }

  #follow() {
    if (this.#isTaking) return;
    const done = this.#face && standing(this.host);
    if (!done) return;
    const isEdited = done.edits !== this.#done?.edits;
    this.#done = done;
    if (isEdited) this.#told.change();
    this.#told.announce();
  }

  /** The studio was started again, and is empty. */
  async #workAgain() {
    const [face, done] = [this.#face, this.#done];
    if (face) await this.#bringIn(face, done, this.#ticket());
  }

  /**
   * @template T
   * @param {() => T} act
   * @returns {T}
   */
  #watched(act) {
    try {
      return act();
    } catch (error) {
      return this.#mind(error);
    }
  }

  /**
   * A trap is seen to here; whoever asked hears of it in any case.
   *
   * @param {unknown} error
   * @returns {never}
   */
  #mind(error) {
    if (isTrap(error)) this.host.fail(error);
    throw error;
  }
}
