import { cameraErrorCode, hasPicture, stopTracks } from "../photo/camera-stream.js";

/**
 * Size at which frames are processed and shown; the networks get smaller ones.
 *
 * @type {MediaStreamConstraints}
 */
const CONSTRAINTS = { video: { facingMode: "user", width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } } };

/**
 * @typedef {object} CameraListener
 * @property {(time_ms: number) => void} frame the video shows a new frame
 * @property {() => void} changed the camera has started, or was muted or unmuted
 * @property {(code: string, error: unknown) => void} lost the camera could not start, or has ended
 */

/** The camera and its frames. Runs between `open` and `close`, with at most one permission request at a time. */
export class CameraStream {
  #video;
  #listener;
  /** @type {MediaStream | undefined} */
  #stream;
  #isOpen = false;
  /** A permission prompt may outlive the live preview; the next `open` then uses its answer. */
  #isAsked = false;

  /**
   * @param {HTMLVideoElement} video
   * @param {CameraListener} listener
   */
  constructor(video, listener) {
    this.#video = video;
    this.#listener = listener;
  }

  /** Whether the camera shows a picture now. */
  get hasPicture() {
    return hasPicture(this.#stream, this.#video);
  }

  open() {
    this.#isOpen = true;
    if (!this.#isAsked && !this.#stream) this.#ask();
  }

  /** Releases the camera. */
  close() {
    this.#isOpen = false;
    if (this.#stream) stopTracks(this.#stream);
    this.#stream = undefined;
    this.#video.srcObject = null;
  }

  /** Current frame; undefined if there is none. */
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
      const stream = await navigator.mediaDevices.getUserMedia(CONSTRAINTS);
      if (this.#isOpen) this.#begin(stream);
      else stopTracks(stream);
    } catch (error) {
      if (this.#isOpen) this.#listener.lost(cameraErrorCode(error), error);
    } finally {
      this.#isAsked = false;
    }
  }

  /** @param {MediaStream} stream */
  #begin(stream) {
    this.#stream = stream;
    const isOn = () => this.#stream === stream;
    for (const track of stream.getVideoTracks()) {
      track.addEventListener("ended", () => isOn() && this.#listener.lost("camera-lost", "the camera's track ended"));
      // A muted camera delivers black frames.
      for (const change of ["mute", "unmute"]) track.addEventListener(change, () => isOn() && this.#listener.changed());
    }
    this.#video.srcObject = stream;
    this.#video.play().catch((error) => {
      if (isOn()) this.#listener.lost("no-camera", error);
    });
    this.#watch(stream);
    this.#listener.changed();
  }

  /** @param {MediaStream} stream */
  #watch(stream) {
    onNextFrame(this.#video, (time_ms) => {
      if (this.#stream !== stream) return;
      this.#watch(stream);
      this.#listener.frame(time_ms);
    });
  }
}

/**
 * Calls back for the next video frame. Browsers without `requestVideoFrameCallback` poll in animation frames.
 *
 * @param {HTMLVideoElement} video
 * @param {(time_ms: number) => void} callback
 */
function onNextFrame(video, callback) {
  if ("requestVideoFrameCallback" in video) {
    video.requestVideoFrameCallback((_, { mediaTime }) => callback(1000 * mediaTime));
    return;
  }
  const { currentTime } = /** @type {HTMLVideoElement} */ (video);
  const poll = () => {
    const { currentTime: now, srcObject } = /** @type {HTMLVideoElement} */ (video);
    if (now !== currentTime || !srcObject) callback(1000 * now);
    else requestAnimationFrame(poll);
  };
  requestAnimationFrame(poll);
}
