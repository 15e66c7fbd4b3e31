import { byId, onAction } from "../page/dom.js";
import { showError } from "../page/notice.js";
import { asPageError } from "../page/page-error.js";
import { Stopwatch } from "./figures.js";
import { CameraStream } from "./camera-stream.js";
import { LiveBar } from "./live-bar.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../worker/protocol.js").Followed} Followed
 * @typedef {import("../work/work.js").Done} Done
 *
 * @typedef {object} Room
 * @property {Promise<Host | undefined>} host
 * @property {import("../photo/vision-client.js").VisionClient} vision
 * @property {import("../opening.js").Opening} opening
 */

/**
 * The camera live on the stage, with the edits of the face that is open.
 *
 * @param {Room} room
 */
export async function setUpLivePreview(room) {
  const host = await room.host;
  if (!host) return;
  const preview = new LivePreview(host, room);
  onAction("live-preview", () => preview.open());
  // One camera at a time.
  onAction("camera", () => preview.close());
}

/**
 * closed → live → closed, and from live to asleep and back while nobody looks at the page. The camera runs only while the mirror is
 * live. Frames are never queued: of those that come while the worker is busy, the newest is the next.
 *
 * Sides are swapped in what is seen alone, by the stage's camera: frames, landmarks and edits keep theirs.
 */
class LivePreview {
  /** @type {"closed" | "live" | "asleep"} */
  #state = "closed";
  #host;
  #vision;
  #opening;
  #video = byId("live-video", HTMLVideoElement);
  #stream = new CameraStream(this.#video, {
    frame: (time_ms) => this.#follow(time_ms),
    changed: () => this.#write(),
    lost: (code, error) => this.#giveUp(code, error),
  });
  #bar = new LiveBar({
    keep: () => this.#keep(),
    close: () => this.close(),
    figures: () => this.#stopwatch.read(),
  });
  #stopwatch = new Stopwatch();
  /** The frame that is seen. @type {ImageBitmap | undefined} */
  #shown;
  #hasFace = false;
  /** Frames of the camera so far. */
  #frames = 0;
  /** Tells one opening of the mirror from the next. */
  #opened = 0;
  /** While a frame is read as a photo, those that follow are passed over. */
  #isReading = false;
  #sceneBefore = "solid";
  /** @type {Element | null} */
  #opener = null;

  /**
   * @param {Host} host
   * @param {Room} room
   */
  constructor(host, { vision, opening }) {
    this.#host = host;
    this.#vision = vision;
    this.#opening = opening;
    addEventListener("keydown", (event) => {
      const isTaken = event.defaultPrevented || document.querySelector("dialog[open]");
      if (event.key === "Escape" && !isTaken) this.close();
    });
    addEventListener("pagehide", () => this.close());
    document.addEventListener("visibilitychange", () => this.#mindTab());
  }

  open() {
    if (this.#state !== "closed") return;
    this.#opened += 1;
    this.#opener = document.activeElement;
    this.#sceneBefore = document.body.dataset["scene"] ?? "solid";
    this.#host.act((studio) => studio.setBrush(undefined));
    this.#host.act((studio) => studio.choose("scene", "picture"));
    this.#state = "live";
    this.#bar.show(true);
    this.#write();
    this.#stream.open();
  }

  /** The one way out: nothing that the camera gave stays, but for a photo that was kept. */
  close() {
    if (this.#state === "closed") return;
    this.#state = "closed";
    this.#stop();
    this.#host.act((studio) => studio.endLivePreview());
    const scene = this.#sceneBefore;
    this.#host.act((studio) => studio.choose("scene", scene));
    this.#bar.show(false);
    if (this.#opener instanceof HTMLElement && this.#opener.checkVisibility()) this.#opener.focus();
  }

  /** No camera runs for a page that nobody sees. */
  #mindTab() {
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
    this.#stopwatch.clear();
    this.#shown?.close();
    this.#shown = undefined;
    this.#hasFace = false;
    this.#write();
  }

  /** @param {number} time_ms when the frame was taken */
  async #follow(time_ms) {
    const number = ++this.#frames;
    if (this.#isReading) return;
    const opened = this.#opened;
    try {
      const frame = await this.#stream.grab();
      const followed = frame && (await this.#vision.follow(frame, time_ms));
      if (!followed) return;
      if (this.#state === "live" && opened === this.#opened) this.#take(followed, number);
      else followed.frame.close();
    } catch (error) {
      // A worker that died is replaced: the next frame goes to the next one.
      if (this.#state === "live" && opened === this.#opened) showError(error);
    }
  }

  /**
   * @param {Followed} followed
   * @param {number} number of the frame
   */
  #take(followed, number) {
    const { frame, landmarks } = followed;
    this.#hasFace = Boolean(landmarks);
    this.#shown?.close();
    this.#shown = frame;
    if (document.body.dataset["state"] === "face") this.#show(followed, number);
    else if (landmarks && !this.#isReading) this.#read(frame);
    this.#write();
  }

  /**
   * @param {Followed} followed
   * @param {number} number
   */
  #show({ frame, landmarks, took_ms, width_px, height_px }, number) {
    const begun_ms = performance.now();
    try {
      this.#host.attempt((studio) => studio.previewFrame(frame, landmarks));
    } catch (error) {
      // While the studio is started again there is no face; the next frames will find one.
      if (!["no-face", "internal"].includes(asPageError(error).code)) this.#host.fail(error);
      return;
    }
    const at_ms = performance.now();
    const places_px = landmarks && placesOf(landmarks, [width_px, height_px]);
    const worker_ms = took_ms.read + took_ms.landmarks;
    this.#stopwatch.take({ at_ms, worker_ms, page_ms: at_ms - begun_ms, age: this.#frames - number, places_px });
    this.#video.hidden = true;
  }

  /** The face that the mirror is about, where none is open: this frame's. @param {ImageBitmap} frame */
  async #read(frame) {
    const opened = this.#opened;
    this.#isReading = true;
    try {
      const photo = await photoOf(frame);
      if (this.#state !== "live" || opened !== this.#opened) return;
      await this.#opening.openFrame(photo);
      // What went wrong has been said.
      if (document.body.dataset["state"] !== "face" && opened === this.#opened) this.close();
    } finally {
      this.#isReading = false;
    }
  }

  /** What is seen becomes a photo, with its edits, and the mirror ends. */
  async #keep() {
    const frame = this.#shown;
    if (!frame || !this.#hasFace || this.#isReading) return;
    const opened = this.#opened;
    const done = this.#done();
    this.#isReading = true;
    try {
      const photo = await photoOf(frame);
      if (this.#state !== "live" || opened !== this.#opened) return;
      this.#sceneBefore = document.body.dataset["scene"] ?? "solid";
      this.close();
      await this.#opening.openFrame(photo, done);
    } finally {
      this.#isReading = false;
    }
  }

  /** @returns {Done | undefined} what was done to the face that is open */
  #done() {
    this.#host.act((studio) => studio.commit());
    return this.#host.read((state, studio) => {
      const [triangulation = "", density = "0"] = ["triangulation", "density"].map((choice) => state.chosen(choice));
      return { edits: studio.editsJson(), triangulation, density: Number(density) };
    });
  }

  /**
   * @param {string} code
   * @param {unknown} error
   */
  #giveUp(code, error) {
    this.close();
    showError({ code, message: String(error), hint: "" });
  }

  #write() {
    const hasPicture = this.#stream.hasPicture;
    if (!this.#shown) this.#video.hidden = this.#state !== "live";
    const canKeep = this.#state === "live" && this.#hasFace && document.body.dataset["state"] === "face";
    if (!hasPicture) this.#bar.report("camera.asking", false);
    else if (!this.#shown) this.#bar.report("live.looking", false);
    else this.#bar.report(this.#hasFace ? undefined : "live.no-face", canKeep);
  }
}

/**
 * As large as the camera sent it, and without loss: it may be closed while this is under way.
 *
 * @param {ImageBitmap} frame
 */
function photoOf(frame) {
  const canvas = new OffscreenCanvas(frame.width, frame.height);
  canvas.getContext("2d", { alpha: false })?.drawImage(frame, 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * @param {Float32Array} landmarks
 * @param {[number, number]} size_px
 */
function placesOf(landmarks, [width, height]) {
  const places = [];
  for (let at = 0; at + 2 < landmarks.length; at += 3) {
    places.push((landmarks[at] ?? 0) * width, (landmarks[at + 1] ?? 0) * height);
  }
  return places;
}
