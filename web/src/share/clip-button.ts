import { announce } from "../page/announce.ts";
import { byId } from "../page/dom.ts";
import { toast } from "../page/toast.ts";
import { t } from "../words/words.ts";
import { numberedName } from "../work/file-name.ts";
import { save } from "./share.ts";
import type { Host } from "../viewport/host.ts";
import type { WordKey } from "../words/words.ts";
import type { Face } from "../work/face.ts";

const TIMEOUT_MS = 60_000;

/** Abort reason when the user cancels. */
const CANCELLED = "cancelled";

/** Controls that could rotate the face during the recording. */
const BLOCKED = "#viewport, #toolbar, .tabs";

/** Records a clip of the rotating face. A second press or Escape cancels. */
export function setUpClip(host: Host, opening: { face: Face | undefined }) {
  const button = byId("clip", HTMLButtonElement);
  const bar = byId("clip-progress", HTMLProgressElement);
  const line = byId("clip-line", HTMLParagraphElement);
  let recording: AbortController | undefined;
  const setRecording = (next: AbortController | undefined) => {
    recording = next;
    for (const element of document.querySelectorAll(BLOCKED)) element.toggleAttribute("inert", next !== undefined);
    bar.hidden = !next;
    bar.value = 0;
    write(button, next ? "clip.cancel" : "clip.record");
  };
  const record = async () => {
    const [controller, { face }] = [new AbortController(), opening];
    const { signal } = controller;
    setTimeout(() => controller.abort("timeout"), TIMEOUT_MS);
    setRecording(controller);
    line.hidden = true;
    announce(t("clip.recording"));
    try {
      const { recordClip } = await import("./clip.ts");
      const isSameFace = () => opening.face === face;
      const clip = await recordClip(host, { signal, isSameFace, onProgress: (fraction) => (bar.value = fraction) });
      const name = numberedName(face, clip.type === "video/mp4" ? "mp4" : "webm", "turning");
      save(new File([clip], name, { type: clip.type }));
    } catch (error) {
      if (error === CANCELLED) return toast(t("clip.cancelled"));
      console.warn("the clip was not recorded:", error);
      write(line, "clip.interrupted");
      // Its menu may have been closed.
      button.closest<HTMLElement>("[popover]")?.togglePopover(true);
    } finally {
      setRecording(undefined);
    }
  };
  button.addEventListener("click", () => (recording ? recording.abort(CANCELLED) : record()));
  document.addEventListener("visibilitychange", () => recording?.abort("page hidden"));
  addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !recording) return;
    event.stopPropagation();
    recording.abort(CANCELLED);
  }, { capture: true });
  setRecording(undefined);
  button.hidden = typeof MediaRecorder !== "function" || !("captureStream" in HTMLCanvasElement.prototype);
  if (button.hidden) write(line, "clip.unsupported");
}

/** Shows a text, which then follows the language. */
function write(element: HTMLElement, key: WordKey) {
  [element.dataset["text"], element.textContent, element.hidden] = [key, t(key), false];
}
