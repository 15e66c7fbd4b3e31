import { codeOf, hasPicture, stopTracks } from "../photo/camera-stream.js";

/**
 * A frame is shown as large as it is worked on; the networks see it smaller still.
 *
 * @type {MediaStreamConstraints}
 */
const WANTED = { video: { facingMode: "user", width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } } };

/**
 * @typedef {object} Audience whom a film is for
 * @property {(time_ms: number) => void} frame a new frame is on the video
 * @property {() => void} changed the camera has begun, or is silent for a while
 * @property {(code: string, error: unknown) => void} lost it could not begin, or ended by itself
 */

/** The camera and its frames. It is asked for once at a time, and runs only between `open` and `close`. */
export class CameraStream {
  #video;
  #audience;
  /** @type {MediaStream | undefined} */
  #stream;
  #isOpen = false;
  /** The browser's question may outlive the mirror, and the next opening takes the answer. */
  #isAsked = false;

  /**
   * @param {HTMLVideoElement} video
   * @param {Audience} audience
   */
  constructor(video, audience) {
    this.#video = video;
    this.#audience = audience;
  }

  /** Whether what the camera shows now is a picture of something. */
  get hasPicture() {
    return hasPicture(this.#stream, this.#video);
  }

  open() {
    this.#isOpen = true;
    if (!this.#isAsked && !this.#stream) this.#ask();
  }

  /** Nothing that the camera gave stays. */
  close() {
    this.#isOpen = false;
    if (this.#stream) stopTracks(this.#stream);
    this.#stream = undefined;
    this.#video.srcObject = null;
  }

  /** What the camera shows now; nothing while that is no picture. */
  async grab() {
    const stream = this.#stream;
    if (!this.hasPicture) return undefined;
    const frame = await createImageBitmap(this.#video);
    if (stream === this.#stream) return frame;
    frame.close();
    return undefined;
  }

  async #ask() {
    this.#isAsked = true;
    try {
      const stream = await navigator.mediaDevices.getUserMedia(WANTED);
      if (this.#isOpen) this.#begin(stream);
      else stopTracks(stream);
    } catch (error) {
      if (this.#isOpen) this.#audience.lost(codeOf(error), error);
    } finally {
      this.#isAsked = false;
    }
  }

  /** @param {MediaStream} stream */
  #begin(stream) {
    this.#stream = stream;
    const isOn = () => this.#stream === stream;
    for (const track of stream.getVideoTracks()) {
      track.addEventListener("ended", () => isOn() && this.#audience.lost("camera-lost", "the camera's track ended"));
      // A muted camera gives black pictures.
      for (const change of ["mute", "unmute"]) track.addEventListener(change, () => isOn() && this.#audience.changed());
    }
    this.#video.srcObject = stream;
    this.#video.play().catch((error) => {
      if (isOn()) this.#audience.lost("no-camera", error);
    });
    this.#watch(stream);
    this.#audience.changed();
  }

  /** @param {MediaStream} stream */
  #watch(stream) {
    onNextFrame(this.#video, (time_ms) => {
      if (this.#stream !== stream) return;
      this.#watch(stream);
      this.#audience.frame(time_ms);
    });
  }
}

/**
 * Browsers that do not tell of a video's frames are asked with each of their own whether there is another.
 *
 * @param {HTMLVideoElement} video
 * @param {(time_ms: number) => void} tell
 */
function onNextFrame(video, tell) {
  if ("requestVideoFrameCallback" in video) {
    video.requestVideoFrameCallback((_, { mediaTime }) => tell(1000 * mediaTime));
    return;
  }
  const { currentTime } = /** @type {HTMLVideoElement} */ (video);
  const look = () => {
    const { currentTime: now, srcObject } = /** @type {HTMLVideoElement} */ (video);
    if (now !== currentTime || !srcObject) tell(1000 * now);
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}
