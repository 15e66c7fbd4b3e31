import { make } from "../src/dom.ts";
import { Opening } from "../js/opening.js";
import { Host } from "../js/viewport/host.js";
import { LandmarkMarks } from "../js/viewport/landmark-marks.js";
import { setUpViewKeys } from "../js/viewport/shortcuts.js";
import { WholeTexture } from "../js/viewport/whole-texture.js";
import { FaceFiles } from "../js/work/face-files.js";
import { loadWords } from "../js/words/words.js";
import { borrowVision, returnVision } from "./shared-vision.js";

/**
 * @typedef {import("../js/work/face.js").Face} Face
 * @typedef {import("../js/worker/protocol.js").Stage} Stage
 *
 * @typedef {object} Listeners
 * @property {(stage: Stage | "loading", fraction: number) => void} progress
 * @property {() => void} ended the progress is over
 * @property {() => void} face another face is shown
 * @property {() => void} change the edits have changed
 * @property {() => void} announce any state has changed
 * @property {(thrown: unknown, owner: string) => void} error of a background operation, with its owner
 * @property {(owner: string) => void} settled the owner's error no longer applies
 */

/** @type {Listeners} */
const NO_LISTENERS = { progress: () => {}, ended: () => {}, face: () => {}, change: () => {}, announce: () => {}, error: (thrown) => console.error(thrown), settled: () => {} };

/** A face on a canvas with gestures and keys, without the page's interface. */
export class FaceSession {
  #listeners;
  #opening;
  #files;
  /** The face and its history when last seen. @type {{ face: Face, history: string } | undefined} */
  #seen;

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
    const vision = borrowVision();
    this.#opening = new Opening(Promise.resolve(host), vision, {
      progress: listeners.progress,
      opened: () => {
        listeners.face();
        host.announce();
      },
      failed: (error) => {
        throw error;
      },
      ended: (isNewest) => isNewest && listeners.ended(),
    });
    this.#files = new FaceFiles(host, vision, this.#opening);
    new LandmarkMarks(host, { tag });
    setUpViewKeys(host);
    new WholeTexture(host, this.#files);
    host.onChange(() => this.#onChange());
  }

  /** The open face. */
  get face() {
    return this.#opening.face;
  }

  /** All faces of the photo, most prominent first. */
  get faces() {
    return this.#opening.faces;
  }

  /**
   * Opens a photo, GLB or project. A newer call cancels the pending one, which then resolves without effect.
   *
   * @param {Blob | Promise<Blob>} file
   */
  open(file) {
    return this.#opening.openFile(file);
  }

  /**
   * Shows another face of the same photo.
   *
   * @param {number} index
   */
  async openFace(index) {
    const face = this.faces[index];
    if (!face) throw { code: "bad-number", message: `face ${index} of ${this.faces.length}`, hint: "" };
    await this.#opening.openFace(face);
  }

  /**
   * Applies an intent; throws if the studio rejects it.
   *
   * @param {import("../js/viewport/host.js").Intent} intent
   * @returns {import("../wasm/rosto-studio-web.js").Applied}
   */
  apply(intent) {
    return this.host.attempt(intent);
  }

  /**
   * Exports the face.
   *
   * @param {string} format such as "glb"
   * @param {import("../js/worker/protocol.js").FileOptions} options
   */
  async file(format, options) {
    const { bytes, mediaType } = await this.#files.mesh(format, { "base-colour": "whole", ...options });
    return new Blob([bytes], { type: mediaType });
  }

  /** Frees the session's resources. */
  close() {
    this.#opening.cancel();
    this.host.close();
    returnVision();
  }

  #onChange() {
    const face = this.#opening.remember();
    if (!face) return;
    const history = JSON.stringify(JSON.parse(face.edits ?? "{}").history);
    const isEdited = face === this.#seen?.face && history !== this.#seen.history;
    this.#seen = { face, history };
    if (isEdited) this.#listeners.change();
    this.#listeners.announce();
  }
}
