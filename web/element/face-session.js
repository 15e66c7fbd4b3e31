import { make } from "../js/page/dom.js";
import { Replaced } from "../js/photo/vision-client.js";
import { openFace, openPictures } from "../js/photo/open-picture.js";
import { Host } from "../js/viewport/host.js";
import { LandmarkMarks } from "../js/viewport/landmark-marks.js";
import { isTrap } from "../js/viewport/studio-module.js";
import { setUpViewKeys } from "../js/viewport/shortcuts.js";
import { WholeTexture } from "../js/viewport/whole-texture.js";
import { editStateOf } from "../js/work/edit-state.js";
import { stemOf } from "../js/work/file-name.js";
import { photosOf } from "../js/work/photos.js";
import { kindOf, readSavedFile } from "../js/work/saved-file.js";
import { loadWords } from "../js/words/words.js";
import { exportedFile } from "../js/work/exported-file.js";
import { borrowVision, facesIn, returnVision } from "./shared-vision.js";

/**
 * @typedef {import("../js/work/work.js").OpenedFace} OpenedFace
 * @typedef {import("../js/work/work.js").EditState} EditState
 * @typedef {import("../js/worker/protocol.js").Stage} Stage
 *
 * @typedef {object} Listeners
 * @property {(stage: Stage | "loading", fraction: number) => void} progress
 * @property {() => void} face another face is shown
 * @property {() => void} change the edits have changed
 * @property {() => void} announce any state has changed
 * @property {(thrown: unknown, owner: string) => void} error of a background operation, with its owner
 * @property {(owner: string) => void} settled the owner's error no longer applies
 */

/** @type {Listeners} */
const NO_LISTENERS = { progress: () => {}, face: () => {}, change: () => {}, announce: () => {}, error: (thrown) => console.error(thrown), settled: () => {} };

/** A face on a canvas with gestures and keys, without the page's interface. */
export class FaceSession {
  /** Queue: opening a face takes several tasks. @type {Promise<unknown>} */
  #last = Promise.resolve();
  #newest = 0;
  #listeners;
  #texture;
  /** @type {OpenedFace | undefined} */
  #face;
  /** @type {OpenedFace[]} */
  #faces = [];
  /** @type {EditState | undefined} */
  #edits;
  #isOpening = false;

  /**
   * Opens a session on an unused canvas; throws `{code: "no-webgl", …}` if the browser cannot draw in 3D.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Partial<Listeners>} [listeners]
   * @param {HTMLOutputElement} [tag] next to the canvas, shows landmark names
   */
  static async open(canvas, listeners = {}, tag = make("output")) {
    const all = { ...NO_LISTENERS, ...listeners };
    await loadWords(navigator.language);
    return new FaceSession(await Host.open(canvas, { show: all.error, hide: all.settled }), tag, all);
  }

  /**
   * @param {Host} host
   * @param {HTMLOutputElement} tag
   * @param {Listeners} listeners
   */
  constructor(host, tag, listeners) {
    this.host = host;
    this.#listeners = listeners;
    new LandmarkMarks(host, { tag });
    setUpViewKeys(host);
    this.#texture = new WholeTexture(host, borrowVision(), this, () => {});
    host.onChange(() => this.#onChange());
    host.onRestart(() => this.#restore());
  }

  /** The open face. */
  get face() {
    return this.#face;
  }

  /** All faces of the photo, most prominent first. */
  get faces() {
    return this.#faces;
  }

  /**
   * Opens a photo, GLB or project. A newer call rejects the pending one with `Replaced`.
   *
   * @param {Blob} file
   */
  async open(file) {
    const isWanted = this.#ticket();
    const kind = await kindOf(file);
    if (kind === "other") {
      const faces = await facesIn(file, stemOf(file), this.#listeners.progress, isWanted);
      return this.#show(faces, 0, undefined, isWanted);
    }
    const { face, changedElsewhere: _, ...edits } = await readSavedFile(file, kind);
    return this.#show([face], 0, edits, isWanted);
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
   * Applies an intent; throws if the studio rejects it.
   *
   * @param {(studio: import("../js/viewport/host.js").Studio) => import("../js/viewport/host.js").ChangeName | void} intent
   */
  apply(intent) {
    return this.#guarded(() => this.host.attempt(intent));
  }

  /**
   * Exports the face.
   *
   * @param {string} format such as "glb"
   * @param {import("../js/work/exported-file.js").ExportChoices} chosen
   */
  async file(format, chosen) {
    if (!this.#face) throw { code: "no-face", message: "no face is open", hint: "" };
    const file = exportedFile(this.host, this.#texture, format, { "base-colour": "whole", ...chosen });
    const bytes = await file.catch((error) => this.#rethrow(error));
    return new Blob([/** @type {BlobPart} */ (bytes)], { type: this.host.answer((studio) => studio.mediaType(format)) });
  }

  /** Frees the session's resources. */
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
   * @param {EditState | undefined} edits
   * @param {() => boolean} isWanted
   */
  async #show(faces, index, edits, isWanted) {
    const face = faces[index];
    if (!face) throw { code: "bad-number", message: `face ${index} of ${faces.length}`, hint: "" };
    const shown = this.#last.then(() => this.#openFace(face, edits, isWanted));
    this.#last = shown.catch(() => {});
    await shown;
    this.#faces = faces;
    this.#listeners.face();
    this.host.announce();
  }

  /**
   * @param {OpenedFace} face
   * @param {EditState | undefined} edits
   * @param {() => boolean} isWanted
   */
  async #openFace(face, edits, isWanted) {
    const photos = photosOf({ ...face, lens: edits?.lens ?? face.lens });
    if (!isWanted() || !(await openPictures(this.host, photos, isWanted))) throw new Replaced();
    this.#isOpening = true;
    try {
      this.#guarded(() => openFace(this.host, photos, edits));
      this.#face = face;
    } finally {
      this.#isOpening = false;
    }
    this.#edits = editStateOf(this.host);
  }

  #onChange() {
    if (this.#isOpening) return;
    const edits = this.#face && editStateOf(this.host);
    if (!edits) return;
    const isEdited = edits.edits !== this.#edits?.edits;
    this.#edits = edits;
    if (isEdited) this.#listeners.change();
    this.#listeners.announce();
  }

  /** Restores the face after the studio has restarted. */
  async #restore() {
    const [face, edits] = [this.#face, this.#edits];
    if (face) await this.#openFace(face, edits, this.#ticket());
  }

  /**
   * @template T
   * @param {() => T} act
   * @returns {T}
   */
  #guarded(act) {
    try {
      return act();
    } catch (error) {
      return this.#rethrow(error);
    }
  }

  /**
   * Rethrows an error to the caller; after a wasm trap, also restarts the studio.
   *
   * @param {unknown} error
   * @returns {never}
   */
  #rethrow(error) {
    if (isTrap(error)) this.host.fail(error);
    throw error;
  }
}
