import { byId, onAction } from "../page/dom.ts";
import { showError } from "../page/notice.ts";
import { asPageError } from "../page/page-error.ts";
import { FrameStats } from "./frame-stats.ts";
import { CameraStream } from "./camera-stream.ts";
import { LiveBar } from "./live-bar.ts";
import { withoutPhotoEdit } from "../work/face.ts";
import type { Host } from "../viewport/host.ts";
import type { FollowedFrame } from "../worker/protocol.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Opening } from "../opening.ts";

export interface Context {
  host: Promise<Host | undefined>;
  vision: VisionClient;
  opening: Opening;
}

/** Sets up the live preview: the camera on the stage, with the edits of the open face. */
export async function setUpLivePreview(context: Context) {
  const host = await context.host;
  if (!host) return;
  const preview = new LivePreview(host, context);
  onAction("live-preview", () => preview.open());
  // One camera at a time.
  onAction("camera", () => preview.close());
}

/**
 * States: closed → live → closed, and live ↔ asleep while the page is hidden. The camera runs only while live. Frames
 * are not queued: a busy worker gets the newest one next.
 *
 * Only the stage's camera mirrors the picture; frames, landmarks and edits keep their sides.
 */
class LivePreview {
  #state: "closed" | "live" | "asleep" = "closed";
  #host;
  #vision;
  #opening;
  #video = byId("live-video", HTMLVideoElement);
  #stream = new CameraStream(this.#video, {
    frame: (time_ms) => this.#follow(time_ms),
    changed: () => this.#write(),
    lost: (code, error) => this.#fail(code, error),
  });
  #bar = new LiveBar({
    save: () => this.#saveFrame(),
    close: () => this.close(),
    figures: () => this.#stats.read(),
  });
  #stats = new FrameStats();
  /** The displayed frame. */
  #shown: ImageBitmap | undefined;
  #hasFace = false;
  /** Number of camera frames so far. */
  #frames = 0;
  /** Identifies the current opening of the preview. */
  #opened = 0;
  /** While a frame is opened as a photo, new frames are ignored. */
  #isReading = false;
  #sceneBefore = "solid";
  #opener: Element | null = null;

  constructor(host: Host, { vision, opening }: Context) {
    this.#host = host;
    this.#vision = vision;
    this.#opening = opening;
    addEventListener("keydown", (event) => {
      const isTaken = event.defaultPrevented || document.querySelector("dialog[open]");
      if (event.key === "Escape" && !isTaken) this.close();
    });
    addEventListener("pagehide", () => this.close());
    document.addEventListener("visibilitychange", () => this.#followVisibility());
  }

  open() {
    if (this.#state !== "closed") return;
    this.#opened += 1;
    this.#opener = document.activeElement;
    this.#sceneBefore = document.body.dataset["scene"] ?? "solid";
    this.#host.apply({ brush: undefined });
    this.#host.apply({ scene: "picture" });
    this.#state = "live";
    this.#bar.show(true);
    this.#write();
    this.#stream.open();
  }

  /** Releases the camera and its frames; a saved frame stays. */
  close() {
    if (this.#state === "closed") return;
    this.#state = "closed";
    this.#stop();
    this.#host.act((studio) => studio.endLivePreview());
    this.#host.apply({ scene: this.#sceneBefore });
    this.#bar.show(false);
    if (this.#opener instanceof HTMLElement && this.#opener.checkVisibility()) this.#opener.focus();
  }

  /** Turns the camera off while the page is hidden. */
  #followVisibility() {
    if (document.visibilityState === "hidden" && this.#state === "live") {
      this.#state = "asleep";
      this.#stop();
    } else if (document.visibilityState === "visible" && this.#state === "asleep") {
      this.#state = "live";
      this.#stream.open();
      this.#write();
    }
  }

  #stop() {
    this.#stream.close();
    this.#vision.stopFollowing();
    this.#stats.clear();
    this.#shown?.close();
    this.#shown = undefined;
    this.#hasFace = false;
    this.#write();
  }

  /** @param time_ms when the frame was taken */
  async #follow(time_ms: number) {
    const number = ++this.#frames;
    if (this.#isReading) return;
    const opened = this.#opened;
    try {
      const frame = await this.#stream.grab();
      const followed = frame && (await this.#vision.follow(frame, time_ms));
      if (!followed) return;
      if (this.#state === "live" && opened === this.#opened) this.#receive(followed, number);
      else followed.frame.close();
    } catch (error) {
      // A crashed worker is replaced; the next frame goes to the new one.
      if (this.#state === "live" && opened === this.#opened) showError(error);
    }
  }

  /** @param number of the frame */
  #receive(followed: FollowedFrame, number: number) {
    const { frame, landmarks } = followed;
    this.#hasFace = Boolean(landmarks);
    this.#shown?.close();
    this.#shown = frame;
    if (document.body.dataset["state"] === "face") this.#show(followed, number);
    else if (landmarks && !this.#isReading) this.#openFrame(frame);
    this.#write();
  }

  #show({ frame, landmarks, took_ms, width_px, height_px }: FollowedFrame, number: number) {
    const begun_ms = performance.now();
    try {
      this.#host.perform((studio) => studio.previewFrame(frame, landmarks));
    } catch (error) {
      // No face is open during a restart; later frames find one.
      if (!["no-face", "internal"].includes(asPageError(error).code)) this.#host.fail(error);
      return;
    }
    const at_ms = performance.now();
    const places_px = landmarks && placesOf(landmarks, [width_px, height_px]);
    const worker_ms = took_ms.read + took_ms.landmarks;
    this.#stats.add({ at_ms, worker_ms, page_ms: at_ms - begun_ms, age: this.#frames - number, places_px });
    this.#video.hidden = true;
  }

  /** Opens a face from this frame if none is open. */
  async #openFrame(frame: ImageBitmap) {
    const opened = this.#opened;
    this.#isReading = true;
    try {
      const photo = await pngOf(frame);
      if (this.#state !== "live" || opened !== this.#opened) return;
      await this.#opening.openFile(photo, "selfie");
      // The error is already shown.
      if (document.body.dataset["state"] !== "face" && opened === this.#opened) this.close();
    } finally {
      this.#isReading = false;
    }
  }

  /** Opens the displayed frame as a photo, with the current edits, and closes the preview. */
  async #saveFrame() {
    const frame = this.#shown;
    if (!frame || !this.#hasFace || this.#isReading) return;
    const opened = this.#opened;
    const edits = this.#edits();
    this.#isReading = true;
    try {
      const photo = await pngOf(frame);
      if (this.#state !== "live" || opened !== this.#opened) return;
      this.#sceneBefore = document.body.dataset["scene"] ?? "solid";
      this.close();
      await this.#opening.openFile(photo, "selfie", edits);
    } finally {
      this.#isReading = false;
    }
  }

  /** Edits of the open face, without those of its photo. */
  #edits() {
    this.#host.apply("commit");
    const { edits } = this.#opening.remember() ?? {};
    return edits === undefined ? undefined : withoutPhotoEdit(edits);
  }

  #fail(code: string, error: unknown) {
    this.close();
    showError({ code, message: String(error), hint: "" });
  }

  #write() {
    const hasPicture = this.#stream.hasPicture;
    if (!this.#shown) this.#video.hidden = this.#state !== "live";
    const canSave = this.#state === "live" && this.#hasFace && document.body.dataset["state"] === "face";
    if (!hasPicture) this.#bar.report("camera.asking", false);
    else if (!this.#shown) this.#bar.report("live.looking", false);
    else this.#bar.report(this.#hasFace ? undefined : "live.no-face", canSave);
  }
}

/** Lossless copy of the frame at full size, so that the frame can be closed meanwhile. */
function pngOf(frame: ImageBitmap) {
  const canvas = new OffscreenCanvas(frame.width, frame.height);
  canvas.getContext("2d", { alpha: false })?.drawImage(frame, 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

function placesOf(landmarks: Float32Array, [width, height]: [number, number]) {
  const places = [];
  for (let at = 0; at + 2 < landmarks.length; at += 3) {
    places.push((landmarks[at] ?? 0) * width, (landmarks[at + 1] ?? 0) * height);
  }
  return places;
}
