/** In order of preference; Safari supports only the last. */
const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

const FRAMES_PER_S = 30;
const BITS_PER_S = 6_000_000;

/** MIME type of the clips that this browser records; undefined if it cannot record a canvas. */
export function clipType() {
  const hasAll = typeof MediaRecorder === "function" && "captureStream" in HTMLCanvasElement.prototype;
  return hasAll ? TYPES.find((type) => MediaRecorder.isTypeSupported(type)) : undefined;
}

/** Records pictures as a clip, in real time. */
export class Recorder {
  #type;
  #context;
  #recorder;
  #parts: Blob[] = [];
  #done;

  /** @param type MIME */
  constructor(type: string, side_px: number) {
    this.#type = type;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [side_px, side_px];
    this.#context = canvas.getContext("2d", { alpha: false });
    this.#recorder = new MediaRecorder(canvas.captureStream(FRAMES_PER_S), { mimeType: type, videoBitsPerSecond: BITS_PER_S });
    this.#recorder.addEventListener("dataavailable", ({ data }) => this.#parts.push(data));
    this.#done = new Promise<void>((resolve, reject) => {
      this.#recorder.addEventListener("stop", () => resolve());
      this.#recorder.addEventListener("error", reject);
    });
    // Avoids an unhandled rejection if recording fails before finish() is called.
    this.#done.catch(() => {});
  }

  /** @param picture the first one starts the clip */
  show(picture: ImageData) {
    this.#context?.putImageData(picture, 0, 0);
    if (this.#recorder.state === "inactive") this.#recorder.start();
  }

  /** Ends the recording and returns the clip, with the MIME type that the browser chose. */
  async finish() {
    this.stop();
    await this.#done;
    const [type = ""] = (this.#recorder.mimeType || this.#type).split(";");
    return new Blob(this.#parts, { type });
  }

  /** Stops capturing the canvas; finish() can still be called. */
  stop() {
    if (this.#recorder.state !== "inactive") this.#recorder.stop();
    for (const track of this.#recorder.stream.getTracks()) track.stop();
  }
}
