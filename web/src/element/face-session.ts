import { make } from "../page/dom.ts";
import { Opening } from "../opening.ts";
import { VisionClient } from "../photo/vision-client.ts";
import { Host, type Notices } from "../viewport/host.ts";
import { setUpGestures } from "../viewport/gestures.ts";
import { setUpMarks } from "../viewport/landmark-marks.ts";
import { setUpKeys } from "../viewport/shortcuts.ts";
import { followTexture } from "../viewport/whole-texture.ts";
import { faceFiles } from "../work/face-files.ts";
import { loadWords } from "../words/words.ts";
import { choices, index, oneOf, plain } from "./checks.ts";
import type { Face } from "../work/face.ts";
import type { Stage } from "../worker/protocol.ts";
import type { Intent } from "../../wasm/rosto-studio-web.js";

export interface Listeners extends Notices {
  /** `stage` is undefined when the progress is over */
  progress: (stage?: Stage | "loading", fraction?: number) => void;
  /** another face is shown */
  face: () => void;
  /** any state has changed; `isEdited`: the edits have */
  change: (isEdited: boolean) => void;
}

/** One worker for all sessions of a page, as its networks are the largest part of Rosto. */
const vision = new VisionClient();
const sessions = new Set<FaceSession>();

/** A face on a canvas with gestures and keys, without the page's interface. */
export class FaceSession {
  readonly host: Host;
  #listeners: Partial<Listeners>;
  #opening;
  #files;
  /** The face and its history when last seen. */
  #seen: { face: Face; history: string } | undefined;

  /**
   * Opens a session on an unused canvas; throws `{code: "no-webgl", …}` if the browser cannot draw in 3D.
   *
   * @param tag next to the canvas, shows landmark names
   */
  static async open(canvas: HTMLCanvasElement, listeners: Partial<Listeners> = {}, tag = make("output")) {
    await loadWords(navigator.language);
    const host = await Host.open(canvas, { show: console.error, hide: () => {}, ...listeners });
    return new FaceSession(host, tag, listeners);
  }

  private constructor(host: Host, tag: HTMLOutputElement, listeners: Partial<Listeners>) {
    [this.host, this.#listeners] = [host, listeners];
    sessions.add(this);
    this.#opening = new Opening(Promise.resolve(host), vision, {
      progress: (stage, fraction) => listeners.progress?.(stage, fraction),
      opened: () => {
        listeners.face?.();
        host.announce();
      },
      failed: (error) => {
        throw error;
      },
      ended: (isNewest) => isNewest && listeners.progress?.(),
    });
    this.#files = faceFiles(host, vision, this.#opening);
    setUpMarks(host, { tag });
    setUpGestures(host);
    setUpKeys(host, host.canvas.getRootNode());
    followTexture(host, this.#files);
    host.on("change", () => this.#onChange());
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
  async openFace(number: number) {
    const face = this.faces[index("index", number, this.faces.length)];
    if (face) await this.#opening.openFace(face);
  }

  /** Applies an intent; throws if the studio rejects it. */
  apply(intent: Intent) {
    return this.host.attempt(plain("intent", intent) as Intent);
  }

  /**
   * Exports the face.
   *
   * @param format such as "glb"
   * @param options by id, such as `{ "base-colour": "photo" }`
   */
  async file(format: string, options: Record<string, string> = {}) {
    const [id, ids] = [oneOf("format", format, this.host.catalogue.formats), choices("choices", options)];
    const { bytes, mediaType } = await this.#files.mesh(id, { "base-colour": "whole", ...ids });
    return new Blob([bytes], { type: mediaType });
  }

  /** Frees the session's resources. */
  close() {
    this.#opening.cancel();
    this.host.close();
    sessions.delete(this);
    if (sessions.size === 0) vision.end();
  }

  #onChange() {
    const face = this.#opening.remember();
    if (!face) return;
    const history = JSON.stringify(JSON.parse(face.edits ?? "{}").history);
    const isEdited = face === this.#seen?.face && history !== this.#seen.history;
    this.#seen = { face, history };
    this.#listeners.change?.(isEdited);
  }
}
