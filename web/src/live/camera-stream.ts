import { cameraErrorCode, hasPicture, stopTracks } from "../photo/camera-stream.ts";

/** Size at which frames are processed and shown; the networks get smaller ones. */
const CONSTRAINTS: MediaStreamConstraints = { video: { facingMode: "user", width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } } };

export interface CameraListener {
  /** the video shows a new frame */
  frame: (time_ms: number) => void;
  /** the camera has started, or was muted or unmuted */
  changed: () => void;
  /** the camera could not start, or has ended */
  lost: (code: string, error: unknown) => void;
}

/** The camera and its frames. Runs between `open` and `close`, with at most one permission request at a time. */
export class CameraStream {
  #video;
  #listener;
  #stream: MediaStream | undefined;
  #isOpen = false;
  /** A permission prompt may outlive the live preview; the next `open` then uses its answer. */
  #isAsked = false;

  constructor(video: HTMLVideoElement, listener: CameraListener) {
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

  #begin(stream: MediaStream) {
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

  #watch(stream: MediaStream) {
    onNextFrame(this.#video, (time_ms) => {
      if (this.#stream !== stream) return;
      this.#watch(stream);
      this.#listener.frame(time_ms);
    });
  }
}

/** Calls back for the next video frame. Browsers without `requestVideoFrameCallback` poll in animation frames. */
function onNextFrame(video: HTMLVideoElement, callback: (time_ms: number) => void) {
  if ("requestVideoFrameCallback" in video) {
    video.requestVideoFrameCallback((_, { mediaTime }) => callback(1000 * mediaTime));
    return;
  }
  const { currentTime } = (video as HTMLVideoElement);
  const poll = () => {
    const { currentTime: now, srcObject } = (video as HTMLVideoElement);
    if (now !== currentTime || !srcObject) callback(1000 * now);
    else requestAnimationFrame(poll);
  };
  requestAnimationFrame(poll);
}
