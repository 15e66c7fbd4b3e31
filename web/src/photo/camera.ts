import { byId, onAction } from "../page/dom.ts";
import { showError } from "../page/notice.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { cameraStream, pngOf } from "./camera-stream.ts";

const COUNTDOWN_S = 3;
const WANTED = { width: { ideal: 1920 }, height: { ideal: 1080 } };

/** Sets up the camera dialog. Its preview is mirrored; the photo is not. */
export function setUpCamera(openPhoto: (photo: Blob) => void) {
  const dialog = byId("camera", HTMLDialogElement);
  const video = byId("camera-preview", HTMLVideoElement);
  const countdown = byId("camera-countdown", HTMLOutputElement);
  const shutter = byId("camera-shutter", HTMLButtonElement);
  /** Timer of the countdown; 0 before it. */
  let timer = 0;
  const stream = cameraStream(video, WANTED, { changed: render, lost: fail });

  onAction("camera", () => {
    if (dialog.open) return;
    dialog.showModal();
    stream.open();
    render();
  });
  onAction("close-camera", (event) => isFirstClick(event) && close());
  shutter.addEventListener("click", (event) => isFirstClick(event) && count(COUNTDOWN_S));
  dialog.addEventListener("cancel", close);
  // Fires asynchronously: the dialog may be open again by then.
  dialog.addEventListener("close", () => dialog.open || close());
  video.addEventListener("resize", render);
  addEventListener("pagehide", close);
  onLocaleChange(render);

  function count(left_s: number) {
    countdown.textContent = left_s > 0 ? String(left_s) : t("camera.taken");
    if (left_s > 0) timer = setTimeout(count, 1000, left_s - 1);
    else take().catch(fail);
    render();
  }

  async function take() {
    if (!stream.hasPicture()) throw { code: "camera-lost", message: "the camera is muted", hint: "" };
    const ticket = timer;
    const frame = await stream.grab();
    // The dialog was closed meanwhile.
    if (timer !== ticket) return frame?.close();
    if (!frame) throw { code: "camera-lost", message: "the camera has no frame", hint: "" };
    const photo = await pngOf(frame);
    frame.close();
    if (timer !== ticket) return;
    close();
    openPhoto(photo);
  }

  function fail(error: unknown) {
    close();
    showError(error);
  }

  function close() {
    clearTimeout(timer);
    timer = 0;
    countdown.textContent = "";
    stream.close();
    dialog.close();
    render();
  }

  function render() {
    const isReady = timer === 0 && stream.hasPicture();
    const becomesReady = isReady && shutter.disabled;
    shutter.disabled = !isReady;
    if (becomesReady) shutter.focus();
    const isWaiting = dialog.open && timer === 0 && !isReady;
    byId("camera-status", HTMLParagraphElement).textContent = isWaiting ? t("camera.asking") : "";
  }
}

/** False for the second click of a double click: it would hit a button of the dialog that the first one opened. */
function isFirstClick(click: MouseEvent) {
  return click.detail < 2;
}
