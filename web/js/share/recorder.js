/** The best first; Safari offers the last alone. */
const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

const FRAMES_PER_S = 30;
const BITS_PER_S = 6_000_000;

/** The kind of clip that this browser records; none where it records no canvas. */
export function clipType() {
  const hasAll = typeof MediaRecorder === "function" && "captureStream" in HTMLCanvasElement.prototype;
  return hasAll ? TYPES.find((type) => MediaRecorder.isTypeSupported(type)) : undefined;
}

/** Makes a clip of pictures as they come. */
export class Recorder {
  #asked;
  #context;
  #recorder;
  /** @type {Blob[]} */
  #parts = [];
  #done;

  /**
   * @param {string} type MIME
   * @param {number} side_px
   */
  constructor(type, side_px) {
    this.#asked = type;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [side_px, side_px];
    this.#context = canvas.getContext("2d", { alpha: false });
    this.#recorder = new MediaRecorder(canvas.captureStream(FRAMES_PER_S), { mimeType: type, videoBitsPerSecond: BITS_PER_S });
    this.#recorder.addEventListener("dataavailable", ({ data }) => this.#parts.push(data));
    this.#done = new Promise((/** @type {(value: void) => void} */ resolve, reject) => {
      this.#recorder.addEventListener("stop", () => resolve());
      this.#recorder.addEventListener("error", reject);
    });
    // It may fail before anybody waits for it.
    this.#done.catch(() => {});
  }

  /** @param {ImageData} picture the first one starts the clip */
  show(picture) {
    this.#context?.putImageData(picture, 0, 0);
    if (this.#recorder.state === "inactive") this.#recorder.start();
  }

  /** The clip, of the type that the browser has made of it. */
  async finish() {
    this.stop();
    await this.#done;
    const [type = ""] = (this.#recorder.mimeType || this.#asked).split(";");
    return new Blob(this.#parts, { type });
  }

  /** Lets go of the canvas; what was recorded may still be asked for. */
  stop() {
    if (this.#recorder.state !== "inactive") this.#recorder.stop();
    for (const track of this.#recorder.stream.getTracks()) track.stop();
  }
}
