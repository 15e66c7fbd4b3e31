import { byId, onAction } from "../page/dom.ts";
import { showError } from "../page/notice.ts";
import { asPageError } from "../page/page-error.ts";
import { cameraStream, pngOf } from "../photo/camera-stream.ts";
import { withoutPhotoEdit } from "../work/face.ts";
import { figuresOf } from "./frame-stats.ts";
import { liveBar } from "./live-bar.ts";
import type { Sample } from "./frame-stats.ts";
import type { Host } from "../viewport/host.ts";
import type { FollowedFrame } from "../worker/protocol.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Opening } from "../opening.ts";

/** Size at which frames are processed and shown; the networks get smaller ones. */
const WANTED = { width: { ideal: 1280 }, height: { ideal: 720 }, frameRate: { ideal: 30 } };

/** Time over which the figures are means. */
const FIGURES_MS = 1000;

type Context = { host: Promise<Host | undefined>; vision: VisionClient; opening: Opening };

/** Sets up the live preview: the camera on the stage, with the edits of the open face. */
export async function setUpLivePreview(context: Context) {
  const host = await context.host;
  if (host) setUp(host, context);
}

/**
 * The camera is off while the page is hidden. Frames are not queued: a busy worker gets the newest one next.
 *
 * Only the stage's camera mirrors the picture; frames, landmarks and edits keep their sides.
 */
function setUp(host: Host, { vision, opening }: Context) {
  const video = byId("live-video", HTMLVideoElement);
  const stream = cameraStream(video, WANTED, { changed: write, lost: fail, frame: follow });
  const bar = liveBar(save, () => figuresOf(samples));
  let isOpen = false;
  /** Identifies the current run of the camera; undefined while it is off. */
  let run: object | undefined;
  let samples: Sample[] = [];
  /** The displayed frame. */
  let shown: ImageBitmap | undefined;
  let hasFace = false;
  /** Number of camera frames so far. */
  let frames = 0;
  /** While a frame is opened as a photo, new frames are ignored. */
  let isReading = false;
  let sceneBefore = "solid";
  let opener: Element | null = null;

  onAction("live-preview", open);
  onAction("close-live-preview", close);
  // One camera at a time.
  onAction("camera", close);
  addEventListener("keydown", ({ key, defaultPrevented }) => {
    if (key === "Escape" && !defaultPrevented && !document.querySelector("dialog[open]")) close();
  });
  addEventListener("pagehide", close);
  document.addEventListener("visibilitychange", () => {
    if (isOpen && document.visibilityState === "hidden") stop();
    else if (isOpen) start();
  });

  function open() {
    if (isOpen) return;
    isOpen = true;
    opener = document.activeElement;
    sceneBefore = scene();
    host.apply({ brush: undefined });
    host.apply({ scene: "picture" });
    bar.show(true);
    start();
  }

  /** Releases the camera and its frames; a saved frame stays. */
  function close() {
    if (!isOpen) return;
    isOpen = false;
    stop();
    host.act((studio) => studio.endLivePreview());
    host.apply({ scene: sceneBefore });
    bar.show(false);
    if (opener instanceof HTMLElement && opener.checkVisibility()) opener.focus();
  }

  function fail(error: unknown) {
    close();
    showError(error);
  }

  function start() {
    run = {};
    stream.open();
    write();
  }

  function stop() {
    run = undefined;
    stream.close();
    vision.stopFollowing();
    samples = [];
    shown?.close();
    shown = undefined;
    hasFace = false;
    write();
  }

  /** @param time_ms when the frame was taken */
  async function follow(time_ms: number) {
    const number = ++frames;
    const mine = run;
    if (isReading) return;
    try {
      const frame = await stream.grab();
      const followed = frame && (await vision.follow(frame, time_ms));
      if (mine === run && followed) receive(followed, number);
      else followed?.frame.close();
    } catch (error) {
      // A crashed worker is replaced; the next frame goes to the new one.
      if (mine === run) showError(error);
    }
  }

  /** @param number of the frame */
  function receive(followed: FollowedFrame, number: number) {
    hasFace = Boolean(followed.landmarks);
    shown?.close();
    shown = followed.frame;
    if (isFaceOpen()) show(followed, number);
    else if (hasFace && !isReading) openFirst(shown);
    write();
  }

  function show({ frame, ...found }: FollowedFrame, number: number) {
    const begun_ms = performance.now();
    try {
      host.perform((studio) => studio.previewFrame(frame, found.landmarks));
    } catch (error) {
      // No face is open during a restart; later frames find one.
      if (!["no-face", "internal"].includes(asPageError(error).code)) host.fail(error);
      return;
    }
    const at_ms = performance.now();
    samples = samples.filter((sample) => at_ms - sample.at_ms <= FIGURES_MS);
    samples.push({ ...found, at_ms, page_ms: at_ms - begun_ms, age: frames - number });
    video.hidden = true;
  }

  /** Opens a face from a frame if none is open. */
  function openFirst(frame: ImageBitmap) {
    return read(frame, async (photo) => {
      const mine = run;
      await opening.openFile(photo, "selfie");
      // The error is already shown.
      if (!isFaceOpen() && mine === run) close();
    });
  }

  /** Opens the displayed frame as a photo, with the current edits, and closes the preview. */
  function save() {
    if (!shown || !hasFace || isReading) return;
    host.apply("commit");
    const { edits } = opening.remember() ?? {};
    read(shown, (photo) => {
      sceneBefore = scene();
      close();
      return opening.openFile(photo, "selfie", edits && withoutPhotoEdit(edits));
    });
  }

  async function read(frame: ImageBitmap, openPhoto: (photo: Blob) => Promise<void>) {
    const mine = run;
    isReading = true;
    try {
      const photo = await pngOf(frame);
      if (mine === run) await openPhoto(photo);
    } catch (error) {
      if (mine === run) fail(error);
    } finally {
      isReading = false;
    }
  }

  function write() {
    if (!shown) video.hidden = run === undefined;
    if (!stream.hasPicture()) bar.report("camera.asking", false);
    else if (!shown) bar.report("live.looking", false);
    else bar.report(hasFace ? undefined : "live.no-face", hasFace && isFaceOpen());
  }
}

function isFaceOpen() {
  return document.body.dataset["state"] === "face";
}

function scene() {
  return document.body.dataset["scene"] ?? "solid";
}
