import { make } from "../page/dom.ts";
import { Opening } from "../opening.ts";
import { Host } from "../viewport/host.ts";
import { LandmarkMarks } from "../viewport/landmark-marks.ts";
import { setUpViewKeys } from "../viewport/shortcuts.ts";
import { WholeTexture } from "../viewport/whole-texture.ts";
import { FaceFiles } from "../work/face-files.ts";
import { loadWords } from "../words/words.ts";
import { borrowVision, returnVision } from "./shared-vision.ts";
import type { Face } from "../work/face.ts";
import type { Stage } from "../worker/protocol.ts";
import type { Applied, Intent } from "../../wasm/rosto-studio-web.js";
import type { FileOptions } from "../../wasm/rosto-vision-web.js";

export interface Listeners {
  progress: (stage: Stage | "loading", fraction: number) => void;
  /** the progress is over */
  ended: () => void;
  /** another face is shown */
  face: () => void;
  /** the edits have changed */
  change: () => void;
  /** any state has changed */
  announce: () => void;
  /** of a background operation, with its owner */
  error: (thrown: unknown, owner: string) => void;
  /** the owner's error no longer applies */
  settled: (owner: string) => void;
}

const NO_LISTENERS: Listeners = { progress: () => {}, ended: () => {}, face: () => {}, change: () => {}, announce: () => {}, error: (thrown) => console.error(thrown), settled: () => {} };

/** A face on a canvas with gestures and keys, without the page's interface. */
export class FaceSession {
  readonly host: Host;
  #listeners;
  #opening;
  #files;
  /** The face and its history when last seen. */
  #seen: { face: Face; history: string; } | undefined;

  /**
   * Opens a session on an unused canvas; throws `{code: "no-webgl", …}` if the browser cannot draw in 3D.
   *
   * @param tag next to the canvas, shows landmark names
   */
  static async open(canvas: HTMLCanvasElement, listeners: Partial<Listeners> = {}, tag: HTMLOutputElement = make("output")) {
    const all = { ...NO_LISTENERS, ...listeners };
    await loadWords(navigator.language);
    return new FaceSession(await Host.open(canvas, { show: all.error, hide: all.settled }), tag, all);
  }

  constructor(host: Host, tag: HTMLOutputElement, listeners: Listeners) {
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

  /** Opens a photo, GLB or project. A newer call cancels the pending one, which then resolves without effect. */
  open(file: Blob | Promise<Blob>) {
    return this.#opening.openFile(file);
  }

  /** Shows another face of the same photo. */
  async openFace(index: number) {
    const face = this.faces[index];
    if (!face) throw { code: "bad-number", message: `face ${index} of ${this.faces.length}`, hint: "" };
    await this.#opening.openFace(face);
  }

  /** Applies an intent; throws if the studio rejects it. */
  apply(intent: Intent): Applied {
    return this.host.attempt(intent);
  }

  /**
   * Exports the face.
   *
   * @param format such as "glb"
   */
  async file(format: string, options: FileOptions) {
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
