import { byId, onAction } from "../page/dom.ts";
import { showError } from "../page/notice.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { cameraErrorCode, hasPicture, stopTracks } from "./camera-stream.ts";

const COUNTDOWN_S = 3;
const CONSTRAINTS = { video: { facingMode: "user", width: { ideal: 1920 }, height: { ideal: 1080 } } };

/** Sets up the camera dialog. Its preview is mirrored; the photo is not. */
export function setUpCamera(open: (photo: Blob) => void) {
  const camera = new Camera(open);
  onAction("camera", () => camera.start());
}

/**
 * The camera dialog, a state machine: closed → asking → live → counting → closed; each state can return to closed.
 * The camera runs only in the states live and counting. A stream that arrives in a state other than asking is stopped.
 */
class Camera {
  #state: "closed" | "asking" | "live" | "counting" = "closed";
  #dialog = byId("camera", HTMLDialogElement);
  #video = byId("camera-preview", HTMLVideoElement);
  #status = byId("camera-status", HTMLParagraphElement);
  #countdown = byId("camera-countdown", HTMLOutputElement);
  #shutter = byId("camera-shutter", HTMLButtonElement);
  /** The running camera; its identity also detects a reopened dialog. */
  #stream: MediaStream | undefined;
  /** The permission prompt may outlive the dialog; when reopened, the dialog uses the pending request. */
  #isRequesting = false;
  #tick = 0;
  #open;

  constructor(open: (photo: Blob) => void) {
    this.#open = open;
    this.#dialog.addEventListener("cancel", () => this.#close());
    // Fires asynchronously: the dialog may be open again by then.
    this.#dialog.addEventListener("close", () => this.#dialog.open || this.#close());
    this.#video.addEventListener("resize", () => this.#render());
    this.#shutter.addEventListener("click", (event) => isFirstClick(event) && this.#countDown());
    onAction("close-camera", (event) => isFirstClick(event) && this.#close());
    addEventListener("pagehide", () => this.#close());
    onLocaleChange(() => this.#render());
  }

  /** Opens the dialog, and the camera once the browser permits it. */
  start() {
    if (this.#state !== "closed") return;
    this.#setState("asking");
    this.#dialog.showModal();
    if (!this.#isRequesting) this.#request();
  }

  async #request() {
    this.#isRequesting = true;
    try {
      const stream = await navigator.mediaDevices.getUserMedia(CONSTRAINTS);
      if (this.#state === "asking") this.#show(stream);
      else stopTracks(stream);
    } catch (error) {
      if (this.#state === "asking") this.#fail(cameraErrorCode(error), error);
    } finally {
      this.#isRequesting = false;
    }
  }

  #show(stream: MediaStream) {
    this.#stream = stream;
    for (const track of stream.getVideoTracks()) {
      track.addEventListener("ended", () => this.#onLost(stream));
      // A muted camera delivers black frames.
      for (const change of ["mute", "unmute"]) track.addEventListener(change, () => this.#render());
    }
    this.#setState("live");
    this.#video.srcObject = stream;
    this.#video.play().catch((error) => {
      if (this.#stream === stream) this.#fail("no-camera", error);
    });
  }

  #countDown() {
    if (this.#state !== "live" || !this.#hasPicture) return;
    this.#setState("counting");
    this.#count(COUNTDOWN_S);
  }

  #count(left_s: number) {
    this.#countdown.textContent = left_s > 0 ? String(left_s) : t("camera.taken");
    if (left_s > 0) this.#tick = setTimeout(() => this.#count(left_s - 1), 1000);
    else this.#take();
  }

  async #take() {
    const stream = this.#stream;
    if (!this.#hasPicture) return this.#onLost(stream);
    const canvas = new OffscreenCanvas(this.#video.videoWidth, this.#video.videoHeight);
    canvas.getContext("2d")?.drawImage(this.#video, 0, 0);
    const photo = await canvas.convertToBlob({ type: "image/png" });
    // The dialog was closed meanwhile.
    if (this.#stream !== stream) return;
    this.#close();
    this.#open(photo);
  }

  get #hasPicture() {
    return hasPicture(this.#stream, this.#video);
  }

  /** @param stream that ended: camera unplugged, or permission revoked */
  #onLost(stream: MediaStream | undefined) {
    if (stream && this.#stream === stream) this.#fail("camera-lost", "the camera's track ended or is muted");
  }

  #fail(code: string, error: unknown) {
    this.#close();
    showError({ code, message: String(error), hint: "" });
  }

  /** Stops the camera and closes the dialog; the only transition to closed. */
  #close() {
    if (this.#state === "closed") return;
    clearTimeout(this.#tick);
    if (this.#stream) stopTracks(this.#stream);
    this.#stream = undefined;
    this.#video.srcObject = null;
    this.#countdown.textContent = "";
    this.#setState("closed");
    this.#dialog.close();
  }

  #setState(state: "closed" | "asking" | "live" | "counting") {
    this.#state = state;
    this.#render();
  }

  #render() {
    this.#dialog.dataset["state"] = this.#state;
    const isReady = this.#state === "live" && this.#hasPicture;
    const wasDisabled = this.#shutter.disabled;
    this.#shutter.disabled = !isReady;
    if (isReady && wasDisabled) this.#shutter.focus();
    const isWaiting = this.#state === "asking" || (this.#state === "live" && !isReady);
    this.#status.textContent = isWaiting ? t("camera.asking") : "";
  }
}

/** False for the second click of a double click: it would hit a button of the dialog that the first one opened. */
function isFirstClick(click: MouseEvent) {
  return click.detail < 2;
}
