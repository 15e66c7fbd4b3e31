import { announce } from "../page/announce.js";
import { byId } from "../page/dom.js";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { isTrap } from "../viewport/studio-module.js";
import { onLocaleChange, t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { recordClip } from "./clip.js";
import { clipType } from "./recorder.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 */

/** A clip that is not there by then will not come, in ms. */
const PATIENCE_MS = 60_000;

/** What would turn the face while it is recorded. */
const STANDS_STILL = "#viewport, #toolbar, .tabs";

/** A clip of the face as it turns: recorded with one press, and dropped with another or with Escape. */
export class ClipPanel {
  #button = byId("clip", HTMLButtonElement);
  #progress = byId("clip-progress", HTMLProgressElement);
  #line = byId("clip-line", HTMLParagraphElement);
  /** What the line says. @type {"clip.unsupported" | "clip.interrupted" | undefined} */
  #says;
  /** Ends the recording in progress. @type {AbortController | undefined} */
  #end;
  #type = clipType();
  #host;
  #autosave;

  /**
   * @param {Host} host
   * @param {Autosave} autosave
   */
  constructor(host, autosave) {
    this.#host = host;
    this.#autosave = autosave;
    if (!this.#type) this.#says = "clip.unsupported";
    this.#button.addEventListener("click", () => (this.#end ? this.#end.abort("cancelled") : this.#record()));
    addEventListener("keydown", (event) => this.#key(event), { capture: true });
    document.addEventListener("visibilitychange", () => this.#end?.abort("out of sight"));
    onLocaleChange(() => this.#write());
  }

  async #record() {
    const end = new AbortController();
    const timer = setTimeout(() => end.abort("late"), PATIENCE_MS);
    this.#begin(end);
    try {
      const clip = await this.#clip(end.signal);
      this.#progressTo(undefined);
      this.#keep(clip);
    } catch (error) {
      this.#explain(error);
    }
    clearTimeout(timer);
    this.#begin(undefined);
  }

  /** @param {AbortSignal} signal */
  async #clip(signal) {
    const { face } = this.#autosave;
    const isSameFace = () => this.#autosave.face === face;
    const told = (/** @type {number} */ share) => this.#progressTo(share);
    const clip = await recordClip(this.#host, { type: this.#type ?? "", signal, isSameFace, told });
    const ending = clip.type === "video/mp4" ? "mp4" : "webm";
    return new File([clip], fileName(face, ending, "turning"), { type: clip.type });
  }

  /** @param {File} clip */
  #keep(clip) {
    download(clip, clip.name, clip.type);
    toast(t("export.done", { file: clip.name }));
  }

  /** @param {unknown} error that ended it, or the reason why it was ended */
  #explain(error) {
    if (error === "cancelled") return toast(t("clip.cancelled"));
    console.warn("the clip was not recorded:", error);
    this.#says = "clip.interrupted";
    if (isTrap(error)) this.#host.fail(error);
  }

  /** @param {AbortController | undefined} end of the recording that begins; none when one is over */
  #begin(end) {
    this.#end = end;
    if (end) this.#says = undefined;
    for (const element of document.querySelectorAll(STANDS_STILL)) element.toggleAttribute("inert", end !== undefined);
    this.#progressTo(end && 0);
    this.#write();
    if (end) announce(t("clip.recording"));
  }

  /** @param {number | undefined} share recorded */
  #progressTo(share) {
    this.#progress.hidden = share === undefined;
    this.#progress.value = share ?? 0;
  }

  #write() {
    this.#button.hidden = !this.#type;
    this.#button.textContent = t(this.#end ? "clip.cancel" : "clip.record");
    this.#line.hidden = !this.#says;
    this.#line.textContent = this.#says ? t(this.#says) : "";
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.key !== "Escape" || !this.#end) return;
    event.stopPropagation();
    this.#end.abort("cancelled");
  }
}
