import { byId } from "./page/dom.js";
import { hint } from "./page/hint.js";
import { hideNotice, showPhotoError, showError } from "./page/notice.js";
import { hideProgress, showLoading, showStage } from "./page/progress.js";
import { nextTask } from "./page/tasks.js";
import { openPicture } from "./photo/open-picture.js";
import { Replaced } from "./photo/vision-client.js";
import { isTrap } from "./viewport/studio-module.js";
import { bitmapOf } from "./work/pixels.js";
import { kindOf, readSavedFile } from "./work/saved-file.js";
import { faceOf } from "./work/work.js";

/**
 * @typedef {import("./viewport/workbench.js").Workbench} Workbench
 * @typedef {import("./work/work.js").Work} Work
 * @typedef {import("./work/work.js").OpenedFace} OpenedFace
 * @typedef {import("./worker/protocol.js").FoundFaces} FoundFaces
 *
 * @typedef {object} Incoming what is ready to be opened
 * @property {OpenedFace} face
 * @property {ImageBitmap} bitmap its picture
 * @property {import("./work/work.js").Done} [done] what was done to it before
 * @property {FoundFaces} [found] all faces of the photo that it is from
 * @property {number} [extraction_ms] how long finding its landmarks took
 * @property {boolean} [changedElsewhere] whether the file tells of another shape than opens
 *
 * @typedef {object} Room where a face is shown
 * @property {Promise<Workbench | undefined>} bench nothing where the browser cannot draw in 3D
 * @property {import("./photo/photo-overlay.js").PhotoOverlay} overlay
 * @property {import("./photo/face-choice.js").FaceChoice} faceChoice
 * @property {import("./photo/vision-client.js").VisionClient} vision
 * @property {import("./work/autosave.js").Autosave} keeper
 * @property {(extraction_ms: number | undefined) => void} opened
 */

/** A group photo offers this many faces at most. */
const MAX_FACES = 8;

/**
 * The one way in for photos, files, the camera, the sample and restored work. The newest wins, and whatever was on its way
 * before ends without a trace. Nothing is replaced before all of it has been read and checked: a failure leaves the work
 * and what is kept of it as they were.
 */
export class Opening {
  #newest = 0;
  /** One face is brought in after the other: each takes several tasks. @type {Promise<unknown>} */
  #last = Promise.resolve();
  #room;
  /** @type {FoundFaces | undefined} the faces of the photo that is open */
  #found;

  /** @param {Room} room */
  constructor(room) {
    this.#room = room;
  }

  /**
   * A photo, or a project or GLB that was saved before.
   *
   * @param {Blob | Promise<Blob>} file
   */
  openFile(file) {
    return this.#open(async (isWanted) => {
      const blob = await file;
      // The page's own module, which reads saved files, may still be on its way.
      const bench = await this.#room.bench;
      const kind = bench ? await kindOf(blob) : "other";
      if (!isWanted()) throw new Replaced();
      return kind === "other" ? this.#readPhoto(blob, isWanted) : ready(await readSavedFile(blob, kind));
    });
  }

  /**
   * Another face of the photo that is open.
   *
   * @param {number} index
   */
  openFace(index) {
    return this.#open(async () => {
      if (!this.#found) throw new Replaced();
      return { face: faceOf(this.#found, index), bitmap: this.#found.bitmap, found: this.#found };
    });
  }

  /**
   * Work that was kept.
   *
   * @param {() => Promise<Work>} read
   */
  openWork(read) {
    return this.#open(async () => ready(await read()));
  }

  /**
   * Brings work back to a studio that has lost it.
   *
   * @param {Work} work
   */
  async restore(work) {
    const ticket = ++this.#newest;
    await this.#inTurn(await ready(work), () => ticket === this.#newest);
  }

  /** @param {(isWanted: () => boolean) => Promise<Incoming>} read */
  async #open(read) {
    const ticket = ++this.#newest;
    const isWanted = () => ticket === this.#newest;
    hideNotice();
    hideProgress();
    try {
      const incoming = await read(isWanted);
      const isOpen = isWanted() && (await this.#inTurn(incoming, isWanted));
      if (!isOpen) return;
      this.#welcome(incoming);
    } catch (error) {
      if (isTrap(error)) (await this.#room.bench)?.fail(error);
      else if (isWanted() && !(error instanceof Replaced)) showPhotoError(error);
    } finally {
      if (isWanted()) hideProgress();
    }
  }

  /**
   * @param {Blob} photo
   * @param {() => boolean} isWanted
   * @returns {Promise<Incoming>}
   */
  async #readPhoto(photo, isWanted) {
    showLoading();
    // The worker may have to load before it begins.
    let begun_ms = NaN;
    const found = await this.#room.vision.find(photo, MAX_FACES, (stage, fraction) => {
      if (Number.isNaN(begun_ms)) begun_ms = performance.now();
      if (isWanted()) showStage(stage, fraction);
    });
    return { face: faceOf(found, 0), bitmap: found.bitmap, found, extraction_ms: performance.now() - begun_ms };
  }

  /**
   * @param {Incoming} incoming
   * @param {() => boolean} isWanted
   */
  #inTurn(incoming, isWanted) {
    const broughtIn = this.#last.then(() => this.#bringIn(incoming, isWanted));
    this.#last = broughtIn.catch(() => {});
    return broughtIn;
  }

  /**
   * Hands a face to the studio, which takes it whole or not at all. The photo on the panel, its pixels and the face each
   * have a task of their own, so that none keeps the page waiting.
   *
   * @param {Incoming} incoming
   * @param {() => boolean} isWanted
   */
  async #bringIn({ face, bitmap, done }, isWanted) {
    const { bench, overlay, keeper } = this.#room;
    const opened = await bench;
    if (opened && !(await openPicture(opened, face, isWanted))) return false;
    if (!isWanted()) return false;
    keeper.finish();
    opened?.attempt((studio) => {
      const { landmarks, width_px, height_px, colours } = face;
      if (!done) return studio.openFace(landmarks, width_px, height_px, colours);
      return studio.openWork(landmarks, width_px, height_px, colours, done.triangulation, done.density, done.edits);
    });
    const { preferences } = done ?? {};
    if (preferences) opened?.act((studio) => studio.prefer(preferences));
    if (opened) keeper.take(face);
    await nextTask();
    overlay.show(face, bitmap);
    return true;
  }

  /** @param {Incoming} incoming that is open now */
  #welcome({ found, extraction_ms, changedElsewhere }) {
    const { opened } = this.#room;
    document.body.dataset["state"] = document.body.dataset["bench"] === "open" ? "face" : "photo";
    byId("welcome", HTMLElement).hidden = true;
    byId("toolbar", HTMLDivElement).hidden = document.body.dataset["bench"] !== "open";
    // A phone's sheet has no room for the photo beside the tools.
    if (matchMedia("(width < 720px)").matches) byId("section-photo", HTMLDetailsElement).open = false;
    if (found !== this.#found || !found) this.#offer(found);
    opened(extraction_ms);
    if (changedElsewhere) showError({ code: "changed-elsewhere", message: "", hint: "" });
    else if (document.body.dataset["bench"] === "open") hint("drag", "turn");
  }

  /** @param {FoundFaces | undefined} found */
  #offer(found) {
    this.#found = found;
    if (found) this.#room.faceChoice.show(found).catch(showError);
    else this.#room.faceChoice.hide();
  }
}

/**
 * @param {Work & { changedElsewhere?: boolean }} work
 * @returns {Promise<Incoming>}
 */
async function ready({ face, changedElsewhere = false, ...done }) {
  try {
    return { face, bitmap: await bitmapOf(face), done, changedElsewhere };
  } catch (error) {
    throw { code: "bad-kept-work", message: String(error), hint: "" };
  }
}
