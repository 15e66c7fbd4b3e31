import { leadPhotoOf } from "./face.ts";
import type { PhotoType } from "../worker/protocol.ts";
import type { Host } from "../viewport/host.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Face } from "./face.ts";
import type { FileOptions, SolidFacts, WrittenFile } from "../../wasm/rosto-vision-web.js";

/** Name of the files in a zip archive. */
const BUNDLED_NAME = "face";

/** Files of the open face, with its current edits. The worker makes them, to keep the main thread responsive. */
export class FaceFiles {
  #host;
  #vision;
  #opening;

  constructor(host: Host, vision: VisionClient, opening: { remember: () => Face | undefined; }) {
    this.#host = host;
    this.#vision = vision;
    this.#opening = opening;
  }

  /**
   * A mesh, or a zip archive if there are companion files.
   *
   * @param format such as "glb"
   */
  async mesh(format: string, options: FileOptions): Promise<WrittenFile> {
    const { face, files } = this.#open();
    const all = { "texture-size": this.#textureSize(), ...options };
    return this.#vision.request("write", { face, files, format, options: all, name: BUNDLED_NAME });
  }

  async project(): Promise<Uint8Array<ArrayBuffer>> {
    const { face, files } = this.#open();
    return this.#vision.request("write-project", { face, files });
  }

  /** Measures of the body for printing; undefined if only the surface is exported. */
  async solidFacts(options: FileOptions): Promise<SolidFacts | undefined> {
    const { face } = this.#open();
    return this.#vision.request("solid-facts", { face, options, files: [] });
  }

  /** The lead photo with the edits, upright and in sRGB, without metadata such as its location. */
  async editedPhoto(mediaType: PhotoType): Promise<Blob> {
    const { face, lead } = this.#open();
    const { falloffBand } = this.#state();
    return this.#vision.request("edited-photo", { face, files: [lead.source], lead, falloffBand, mediaType });
  }

  /** Cancels the files that are being made. */
  cancel() {
    this.#vision.cancel();
  }

  /** Runs the paper's experiment on the face as it was found; undefined if it was stopped. */
  async paper(report: (share: number) => void) {
    return this.#vision.request("paper", { face: this.#open().face }, (_, share) => report(share));
  }

  stopPaper() {
    this.#vision.request("stop-paper", {}).catch(() => {});
  }

  /** The whole-face texture. */
  async texture(): Promise<ImageBitmap> {
    const { face, files } = this.#open();
    return this.#vision.request("texture", { face, files, size: this.#textureSize() });
  }

  /** The open face in the form of a worker request. Throws `no-face` without one. */
  #open() {
    const face = this.#opening.remember();
    if (!face) throw { code: "no-face", message: "no face is open", hint: "" };
    const { photos, edits, pictures, files } = face;
    return { face: { photos, edits, pictures }, files, lead: leadPhotoOf(face) };
  }

  #textureSize() {
    return this.#state().chosen["texture-size"] ?? "";
  }

  /** The state; throws `restarting` during a restart. */
  #state() {
    return this.#host.answer((studio) => studio.state());
  }
}
