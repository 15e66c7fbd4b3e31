import { byId, onAction } from "../page/dom.js";
import { showError } from "../page/notice.js";
import { onLocaleChange, t } from "../words/words.js";
import { codeOf, hasPicture, stopTracks } from "./camera-stream.js";

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

/**
 * The dialog and the camera behind it: closed → asking → live → counting → closed, and from everywhere back to closed.
 * The camera runs only while the dialog is live or counting: what leaves those states stops it, and a stream that
 * arrives in any state but asking is stopped at once.
 */
class Camera {
  /** @type {"closed" | "asking" | "live" | "counting"} */
  #state = "closed";
  #dialog = byId("camera", HTMLDialogElement);
  #video = byId("camera-preview", HTMLVideoElement);
  #status = byId("camera-status", HTMLParagraphElement);
  #countdown = byId("camera-countdown", HTMLOutputElement);
  #shutter = byId("camera-shutter", HTMLButtonElement);
  /** Of the live camera; also tells one opening of the dialog from the next. @type {MediaStream | undefined} */
  #stream;
  /** The browser is asked once at a time: its question may outlive the dialog, and the next opening takes the answer. */
  #isAsked = false;
  #tick = 0;
  #open;

  /** @param {(photo: Blob) => void} open */
  constructor(open) {
    this.#open = open;
    this.#dialog.addEventListener("cancel", () => this.#close());
    // This one comes late: by then the dialog may be open again.
    this.#dialog.addEventListener("close", () => this.#dialog.open || this.#close());
    this.#video.addEventListener("resize", () => this.#write());
    this.#shutter.addEventListener("click", (event) => isFirst(event) && this.#countDown());
    onAction("close-camera", (event) => isFirst(event) && this.#close());
    addEventListener("pagehide", () => this.#close());
    onLocaleChange(() => this.#write());
  }

  /** Opens the dialog at once, and the camera when the browser lets it. */
  start() {
    if (this.#state !== "closed") return;
    this.#become("asking");
    this.#dialog.showModal();
    if (!this.#isAsked) this.#ask();
  }

  async #ask() {
    this.#isAsked = true;
    try {
      const stream = await navigator.mediaDevices.getUserMedia(WANTED);
      if (this.#state === "asking") this.#show(stream);
      else stopTracks(stream);
    } catch (error) {
      if (this.#state === "asking") this.#giveUp(codeOf(error), error);
    } finally {
      this.#isAsked = false;
    }
  }

  /** @param {MediaStream} stream */
  #show(stream) {
    this.#stream = stream;
    for (const track of stream.getVideoTracks()) {
      track.addEventListener("ended", () => this.#lose(stream));
      // A muted camera gives black pictures.
      for (const change of ["mute", "unmute"]) track.addEventListener(change, () => this.#write());
    }
    this.#become("live");
    this.#video.srcObject = stream;
    this.#video.play().catch((error) => {
      if (this.#stream === stream) this.#giveUp("no-camera", error);
    });
  }

  #countDown() {
    if (this.#state !== "live" || !this.#hasPicture) return;
    this.#become("counting");
    this.#count(COUNTDOWN_S);
  }

  /** @param {number} left_s */
  #count(left_s) {
    this.#countdown.textContent = left_s > 0 ? String(left_s) : t("camera.taken");
    if (left_s > 0) this.#tick = setTimeout(() => this.#count(left_s - 1), 1000);
    else this.#take();
  }

  async #take() {
    const stream = this.#stream;
    if (!this.#hasPicture) return this.#lose(stream);
    const canvas = new OffscreenCanvas(this.#video.videoWidth, this.#video.videoHeight);
    canvas.getContext("2d")?.drawImage(this.#video, 0, 0);
    const photo = await canvas.convertToBlob({ type: "image/png" });
    // Whoever closed the dialog meanwhile wanted no photo.
    if (this.#stream !== stream) return;
    this.#close();
    this.#open(photo);
  }

  /** Whether what the camera shows now is a picture of something. */
  get #hasPicture() {
    return hasPicture(this.#stream, this.#video);
  }

  /** @param {MediaStream | undefined} stream that ended by itself: unplugged, or no longer allowed */
  #lose(stream) {
    if (stream && this.#stream === stream) this.#giveUp("camera-lost", "the camera's track ended or is muted");
  }

  /**
   * @param {string} code
   * @param {unknown} error
   */
  #giveUp(code, error) {
    this.#close();
    showError({ code, message: String(error), hint: "" });
  }

  /** The one way out: nothing that the camera gave stays. */
  #close() {
    if (this.#state === "closed") return;
    clearTimeout(this.#tick);
    if (this.#stream) stopTracks(this.#stream);
    this.#stream = undefined;
    this.#video.srcObject = null;
    this.#countdown.textContent = "";
    this.#become("closed");
    this.#dialog.close();
  }

  /** @param {"closed" | "asking" | "live" | "counting"} state */
  #become(state) {
    this.#state = state;
    this.#write();
  }

  #write() {
    this.#dialog.dataset["state"] = this.#state;
    const isReady = this.#state === "live" && this.#hasPicture;
    const wasDisabled = this.#shutter.disabled;
    this.#shutter.disabled = !isReady;
    if (isReady && wasDisabled) this.#shutter.focus();
    const waits = this.#state === "asking" || (this.#state === "live" && !isReady);
    this.#status.textContent = waits ? t("camera.asking") : "";
  }
}

/**
 * The second half of a double click that opened the dialog lands on what has come up under the pointer.
 *
 * @param {MouseEvent} click
 */
function isFirst(click) {
  return click.detail < 2;
}
