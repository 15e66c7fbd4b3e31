import { byId, onAction } from "../page/dom.js";
import { showPhotoTrouble } from "../page/notice.js";
import { say } from "../words/words.js";

const COUNTDOWN_S = 3;
const WANTED = { video: { facingMode: "user", width: { ideal: 1920 }, height: { ideal: 1080 } } };

/**
 * A photo of whoever sits before the camera. The preview is a mirror; the photo is not.
 *
 * @param {(photo: Blob) => void} open
 */
export function setUpCamera(open) {
  const camera = new Camera(open);
  onAction("camera", () => camera.start());
}

class Camera {
  #dialog = byId("camera", HTMLDialogElement);
  #video = byId("camera-preview", HTMLVideoElement);
  #countdown = byId("camera-countdown", HTMLOutputElement);
  #shutter = byId("camera-shutter", HTMLButtonElement);
  /** @type {MediaStream | undefined} */
  #stream;
  #open;

  /** @param {(photo: Blob) => void} open */
  constructor(open) {
    this.#open = open;
    this.#dialog.addEventListener("close", () => this.#stop());
    this.#shutter.addEventListener("click", () => this.#countDown());
    onAction("close-camera", () => this.#dialog.close());
  }

  async start() {
    try {
      this.#stream = await navigator.mediaDevices.getUserMedia(WANTED);
    } catch (error) {
      return showPhotoTrouble({ code: codeOf(error), message: String(error) });
    }
    this.#dialog.showModal();
    this.#video.srcObject = this.#stream;
    await this.#video.play();
    this.#shutter.disabled = false;
    this.#shutter.focus();
  }

  async #countDown() {
    this.#shutter.disabled = true;
    for (let left_s = COUNTDOWN_S; left_s > 0; left_s--) {
      this.#countdown.textContent = String(left_s);
      await new Promise((resolve) => setTimeout(resolve, 1000));
      if (!this.#dialog.open) return;
    }
    this.#countdown.textContent = say("camera.taken");
    const photo = await this.#capture();
    this.#dialog.close();
    this.#open(photo);
  }

  async #capture() {
    const canvas = new OffscreenCanvas(this.#video.videoWidth, this.#video.videoHeight);
    canvas.getContext("2d")?.drawImage(this.#video, 0, 0);
    return canvas.convertToBlob({ type: "image/png" });
  }

  #stop() {
    for (const track of this.#stream?.getTracks() ?? []) track.stop();
    this.#stream = undefined;
    this.#video.srcObject = null;
    this.#countdown.textContent = "";
  }
}

/** @param {unknown} error */
function codeOf(error) {
  const refused = error instanceof DOMException && error.name === "NotAllowedError";
  return refused ? "camera-refused" : "no-camera";
}
