import { announce } from "../page/announce.ts";
import { byId } from "../page/dom.ts";
import { download } from "../page/download.ts";
import { toast } from "../page/toast.ts";
import { isTrap } from "../studio-module.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { fileName } from "../work/file-name.ts";
import { recordClip } from "./clip.ts";
import { clipType } from "./recorder.ts";
import type { Host } from "../viewport/host.ts";
import type { Face } from "../work/face.ts";

export type Opening = { face: Face | undefined; };

const TIMEOUT_MS = 60_000;

/** Controls that could rotate the face during the recording. */
const BLOCKED = "#viewport, #toolbar, .tabs";

/** Records a clip of the rotating face. A second press or Escape cancels. */
export class ClipPanel {
  #button = byId("clip", HTMLButtonElement);
  #progress = byId("clip-progress", HTMLProgressElement);
  #line = byId("clip-line", HTMLParagraphElement);
  /** Text of the status line. */
  #message: "clip.unsupported" | "clip.interrupted" | undefined;
  /** Cancels the recording in progress. */
  #recording: AbortController | undefined;
  #type = clipType();
  #host;
  #opening;

  constructor(host: Host, opening: Opening) {
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

  async #clip(signal: AbortSignal) {
    const { face } = this.#opening;
    const isSameFace = () => this.#opening.face === face;
    const onProgress = (fraction: number) => this.#setProgress(fraction);
    const clip = await recordClip(this.#host, { type: this.#type ?? "", signal, isSameFace, onProgress });
    const extension = clip.type === "video/mp4" ? "mp4" : "webm";
    return new File([clip], fileName(face, extension, "turning"), { type: clip.type });
  }

  #save(clip: File) {
    download(clip, clip.name, clip.type);
    toast(t("export.done", { file: clip.name }));
  }

  /** @param error or abort reason */
  #showFailure(error: unknown) {
    if (error === "cancelled") return toast(t("clip.cancelled"));
    console.warn("the clip was not recorded:", error);
    this.#message = "clip.interrupted";
    if (isTrap(error)) this.#host.fail(error);
  }

  /** @param recording that starts; undefined when it ends */
  #setRecording(recording: AbortController | undefined) {
    this.#recording = recording;
    if (recording) this.#message = undefined;
    for (const element of document.querySelectorAll(BLOCKED)) element.toggleAttribute("inert", recording !== undefined);
    this.#setProgress(recording && 0);
    this.#render();
    if (recording) announce(t("clip.recording"));
  }

  /** @param fraction recorded; undefined hides the bar */
  #setProgress(fraction: number | undefined) {
    this.#progress.hidden = fraction === undefined;
    this.#progress.value = fraction ?? 0;
  }

  #render() {
    this.#button.hidden = !this.#type;
    this.#button.textContent = t(this.#recording ? "clip.cancel" : "clip.record");
    this.#line.hidden = !this.#message;
    this.#line.textContent = this.#message ? t(this.#message) : "";
  }

  #key(event: KeyboardEvent) {
    if (event.key !== "Escape" || !this.#recording) return;
    event.stopPropagation();
    this.#recording.abort("cancelled");
  }
}
