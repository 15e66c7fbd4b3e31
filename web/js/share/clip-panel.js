import { announce } from "../page/announce.js";
import { byId } from "../../src/dom.ts";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { isTrap } from "../../src/studio-module.ts";
import { onLocaleChange, t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { recordClip } from "./clip.js";
import { clipType } from "./recorder.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {{ face: import("../work/face.js").Face | undefined }} Opening
 */

const TIMEOUT_MS = 60_000;

/** Controls that could rotate the face during the recording. */
const BLOCKED = "#viewport, #toolbar, .tabs";

/** Records a clip of the rotating face. A second press or Escape cancels. */
export class ClipPanel {
  #button = byId("clip", HTMLButtonElement);
  #progress = byId("clip-progress", HTMLProgressElement);
  #line = byId("clip-line", HTMLParagraphElement);
  /** Text of the status line. @type {"clip.unsupported" | "clip.interrupted" | undefined} */
  #message;
  /** Cancels the recording in progress. @type {AbortController | undefined} */
  #recording;
  #type = clipType();
  #host;
  #opening;

  /**
   * @param {Host} host
   * @param {Opening} opening
   */
  constructor(host, opening) {
    this.#host = host;
    this.#opening = opening;
    if (!this.#type) this.#message = "clip.unsupported";
    this.#button.addEventListener("click", () => (this.#recording ? this.#recording.abort("cancelled") : this.#record()));
    addEventListener("keydown", (event) => this.#key(event), { capture: true });
    document.addEventListener("visibilitychange", () => this.#recording?.abort("page hidden"));
    onLocaleChange(() => this.#render());
  }

  async #record() {
    const recording = new AbortController();
    const timer = setTimeout(() => recording.abort("timeout"), TIMEOUT_MS);
    this.#setRecording(recording);
    try {
      const clip = await this.#clip(recording.signal);
      this.#setProgress(undefined);
      this.#save(clip);
    } catch (error) {
      this.#showFailure(error);
    }
    clearTimeout(timer);
    this.#setRecording(undefined);
  }

  /** @param {AbortSignal} signal */
  async #clip(signal) {
    const { face } = this.#opening;
    const isSameFace = () => this.#opening.face === face;
    const onProgress = (/** @type {number} */ fraction) => this.#setProgress(fraction);
    const clip = await recordClip(this.#host, { type: this.#type ?? "", signal, isSameFace, onProgress });
    const extension = clip.type === "video/mp4" ? "mp4" : "webm";
    return new File([clip], fileName(face, extension, "turning"), { type: clip.type });
  }

  /** @param {File} clip */
  #save(clip) {
    download(clip, clip.name, clip.type);
    toast(t("export.done", { file: clip.name }));
  }

  /** @param {unknown} error or abort reason */
  #showFailure(error) {
    if (error === "cancelled") return toast(t("clip.cancelled"));
    console.warn("the clip was not recorded:", error);
    this.#message = "clip.interrupted";
    if (isTrap(error)) this.#host.fail(error);
  }

  /** @param {AbortController | undefined} recording that starts; undefined when it ends */
  #setRecording(recording) {
    this.#recording = recording;
    if (recording) this.#message = undefined;
    for (const element of document.querySelectorAll(BLOCKED)) element.toggleAttribute("inert", recording !== undefined);
    this.#setProgress(recording && 0);
    this.#render();
    if (recording) announce(t("clip.recording"));
  }

  /** @param {number | undefined} fraction recorded; undefined hides the bar */
  #setProgress(fraction) {
    this.#progress.hidden = fraction === undefined;
    this.#progress.value = fraction ?? 0;
  }

  #render() {
    this.#button.hidden = !this.#type;
    this.#button.textContent = t(this.#recording ? "clip.cancel" : "clip.record");
    this.#line.hidden = !this.#message;
    this.#line.textContent = this.#message ? t(this.#message) : "";
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.key !== "Escape" || !this.#recording) return;
    event.stopPropagation();
    this.#recording.abort("cancelled");
  }
}
