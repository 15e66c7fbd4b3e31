import { leadPhotoOf } from "./face.js";

/**
 * @typedef {import("../worker/protocol.js").FileOptions} FileOptions
 * @typedef {import("../worker/protocol.js").SolidFacts} SolidFacts
 * @typedef {import("../worker/protocol.js").WrittenFile} WrittenFile
 */

/** Name of the files in a zip archive. */
const BUNDLED_NAME = "face";

/** Error code if the worker dies. */
const NOT_WRITTEN = "file-not-written";

/** Files of the open face, with its current edits. The worker makes them, to keep the main thread responsive. */
export class FaceFiles {
  #host;
  #vision;
  #opening;

  /**
   * @param {import("../viewport/host.js").Host} host
   * @param {import("../photo/vision-client.js").VisionClient} vision
   * @param {{ remember: () => import("./face.js").Face | undefined }} opening
   */
  constructor(host, vision, opening) {
    this.#host = host;
    this.#vision = vision;
    this.#opening = opening;
  }

  /**
   * A mesh, or a zip archive if there are companion files.
   *
   * @param {string} format such as "glb"
   * @param {FileOptions} options
   * @returns {Promise<WrittenFile>}
   */
  async mesh(format, options) {
    const { face, files } = this.#open();
    const all = { "texture-size": this.#textureSize(), ...options };
    return this.#vision.perform({ type: "write", face, format, options: all, name: BUNDLED_NAME }, files, NOT_WRITTEN);
  }

  /** @returns {Promise<Uint8Array<ArrayBuffer>>} */
  async project() {
    const { face, files } = this.#open();
    return this.#vision.perform({ type: "write-project", face }, files, NOT_WRITTEN);
  }

  /**
   * Measures of the body for printing; undefined if only the surface is exported.
   *
   * @param {FileOptions} options
   * @returns {Promise<SolidFacts | undefined>}
   */
  async solidFacts(options) {
    const { face } = this.#open();
    return this.#vision.perform({ type: "solid-facts", face, options }, [], "worker-died");
  }

  /**
   * The lead photo with the edits, upright and in sRGB, without metadata such as its location.
   *
   * @param {import("../worker/protocol.js").PhotoType} mediaType
   * @returns {Promise<Blob>}
   */
  async editedPhoto(mediaType) {
    const { face, lead } = this.#open();
    const { falloffBand } = this.#state();
    return this.#vision.perform({ type: "edited-photo", face, lead, falloffBand, mediaType }, [lead.source], "photo-not-written");
  }

  /**
   * The whole-face texture.
   *
   * @returns {Promise<ImageBitmap>}
   */
  async texture() {
    const { face, files } = this.#open();
    return this.#vision.perform({ type: "texture", face, size: this.#textureSize() }, files, "worker-died");
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
