import { byId } from "./page/dom.js";
import { resetPanel } from "./page/reset-panel.js";
import { showHints } from "./page/hint.js";
import { dismissNotices, showError, showNotAdded, showRemark } from "./page/notice.js";
import { hideProgress } from "./page/progress.js";
import { nextTask } from "./page/tasks.js";
import { openFace, openPicture, openPictures } from "./photo/open-picture.js";
import { readPhoto } from "./photo/read-photo.js";
import { Replaced } from "./photo/vision-client.js";
import { isTrap } from "./viewport/studio-module.js";
import { stemOf } from "./work/file-name.js";
import { fromVisit, fromWork, recentFaces, shownBefore } from "./work/incoming.js";
import { detectionOf, faceFromPhotos, indexOfPhoto, photoFacts, photosOf } from "./work/photos.js";
import { bitmapOf } from "./work/pixels.js";
import { kindOf, readSavedFile } from "./work/saved-file.js";

/**
 * @typedef {import("./viewport/host.js").Host} Host
 * @typedef {import("./work/work.js").Work} Work
 * @typedef {import("./work/work.js").OpenedFace} OpenedFace
 * @typedef {import("./work/incoming.js").ShownFace} ShownFace
 * @typedef {import("./work/incoming.js").Incoming} Incoming
 *
 * @typedef {object} Context
 * @property {Promise<Host | undefined>} host undefined if the browser cannot draw in 3D
 * @property {import("./photo/photo-overlay.js").PhotoOverlay} overlay
 * @property {import("./photo/face-choice.js").FaceChoice} faceChoice
 * @property {import("./photo/vision-client.js").VisionClient} vision
 * @property {import("./work/autosave.js").Autosave} autosave
 * @property {(extraction_ms: number | undefined) => void} opened
 */

/**
 * Single entry point for photos, files, the camera, the sample and restored work. A newer request cancels the pending
 * one. A face replaces the current one only after it was read and checked, so a failure leaves the current and the
 * saved work unchanged.
 */
export class Opening {
  #newest = 0;
  /** Queue: a change takes several tasks, and changes must not interleave. @type {Promise<unknown>} */
  #queue = Promise.resolve();
  #context;
  /** @type {ShownFace | undefined} */
  #current;
  /** Faces shown before, latest first. @type {ShownFace[]} */
  #earlier = [];

  /** @param {Context} context */
  constructor(context) {
    this.#context = context;
  }

  /** Lens detected in the current photo. */
  get lens() {
    return this.#current?.face.lens;
  }

  get face() {
    return this.#current?.face;
  }

  /**
   * Opens a photo, project or GLB.
   *
   * @param {Blob | Promise<Blob>} file
   * @param {string} [name] overrides the file's name
   */
  openFile(file, name) {
    return this.#open(async (isWanted) => {
      const blob = await file;
      // Saved files are read by the page's module, which may still be loading.
      const host = await this.#context.host;
      const kind = host ? await kindOf(blob) : "other";
      if (!isWanted()) throw new Replaced();
      if (kind === "other") return readPhoto(this.#context.vision, blob, name ?? stemOf(blob), isWanted);
      return fromWork(await readSavedFile(blob, kind));
    });
  }

  /**
   * Opens a frame of the live preview, with the edits shown in it.
   *
   * @param {Blob} photo
   * @param {import("./work/work.js").EditState} [edits]
   */
  openFrame(photo, edits) {
    return this.#open(async (isWanted) => {
      const incoming = await readPhoto(this.#context.vision, photo, "selfie", isWanted);
      return edits ? { ...incoming, edits } : incoming;
    });
  }

  /**
   * Opens another face of the current photo; ignored if `face` is from another photo.
   *
   * @param {OpenedFace} face
   */
  openFace(face) {
    const { faces = [] } = this.#current ?? {};
    return this.#open(() => this.#reopen(faces.includes(face) ? { face, faces } : undefined));
  }

  /**
   * Returns to a face shown earlier.
   *
   * @param {OpenedFace} face
   */
  goBackTo(face) {
    return this.#open(() => this.#reopen(this.#earlier.find((shown) => shown.face === face)));
  }

  /**
   * Adds further photos of the open face. Reports each photo that cannot be added.
   *
   * @param {File[]} files
   */
  addPhotos(files) {
    return this.#run(async (isWanted) => {
      const host = await this.#context.host;
      for (const file of files) {
        if (!host || !isWanted()) return;
        await this.#addPhoto(host, file, isWanted).catch((error) => {
          if (isTrap(error) || error instanceof Replaced) throw error;
          showNotAdded(file.name, error);
        });
      }
    });
  }

  /**
   * Removes a photo from the open face. Its index is looked up when the queue reaches it, as earlier changes may move
   * or remove it.
   *
   * @param {OpenedFace} photo
   */
  removePhoto(photo) {
    return this.#run(async () => {
      const host = await this.#context.host;
      if (!host) return;
      await this.#enqueue(async () => {
        const index = indexOfPhoto(this.#current?.face, photo);
        if (index === undefined) return;
        await this.#changePhotos(host, (studio) => studio.removePhoto(index), (photos) => photos.toSpliced(index, 1));
      });
    });
  }

  /**
   * Restores a photo removed from the open face.
   *
   * @param {OpenedFace} photo
   */
  restorePhoto(photo) {
    return this.#run(async (isWanted) => {
      const host = await this.#context.host;
      if (host) await this.#enqueue(() => this.#addDetected(host, photo, isWanted));
    });
  }

  /**
   * Opens saved work.
   *
   * @param {() => Promise<Work>} read
   */
  openWork(read) {
    return this.#open(async () => fromWork(await read()));
  }

  /**
   * Restores the work after the studio has crashed.
   *
   * @param {Work} work
   */
  async restore(work) {
    const ticket = ++this.#newest;
    const { faces = [work.face] } = this.#current ?? {};
    const incoming = { ...(await fromWork(work)), faces };
    await this.#enqueue(() => this.#install(incoming, () => ticket === this.#newest));
  }

  /** @param {(isWanted: () => boolean) => Promise<Incoming>} read */
  #open(read) {
    return this.#run(async (isWanted) => {
      const incoming = await read(isWanted);
      const isOpen = isWanted() && (await this.#enqueue(() => this.#install(incoming, isWanted)));
      if (isOpen) this.#onOpened(incoming);
      incoming.bitmap.close();
    });
  }

  /**
   * Runs a request, cancels the pending one and reports errors.
   *
   * @param {(isWanted: () => boolean) => Promise<void>} act `isWanted` returns false once a newer request has begun
   */
  async #run(act) {
    const ticket = ++this.#newest;
    const isWanted = () => ticket === this.#newest;
    dismissNotices();
    hideProgress();
    try {
      await act(isWanted);
    } catch (error) {
      if (isTrap(error)) (await this.#context.host)?.fail(error);
      else if (isWanted() && !(error instanceof Replaced)) showError(error);
    } finally {
      if (isWanted()) hideProgress();
      this.#context.faceChoice.mark(this.#current?.face);
    }
  }

  /**
   * @param {Host} host
   * @param {File} file
   * @param {() => boolean} isWanted
   */
  async #addPhoto(host, file, isWanted) {
    const max = host.ask((studio) => studio.maxPhotos) ?? 1;
    if (this.#current && photosOf(this.#current.face).length >= max) throw { code: "too-many-photos", message: `${max} photos`, hint: "" };
    if ((await kindOf(file)) !== "other") throw { code: "not-a-picture", message: "a saved face", hint: "" };
    const { face: photo, bitmap } = await readPhoto(this.#context.vision, file, stemOf(file), isWanted);
    bitmap.close();
    await this.#enqueue(async () => {
      if (!(await this.#addDetected(host, photo, isWanted))) return;
      const adds = host.ask((studio) => photoFacts(studio).at(-1)?.adds);
      if (adds === false) showRemark("adds-little", { name: file.name });
    });
  }

  /**
   * Adds a photo whose landmarks are known. Resolves to false if the face already has it, or the request was cancelled.
   *
   * @param {Host} host
   * @param {OpenedFace} photo
   * @param {() => boolean} isWanted
   */
  async #addDetected(host, photo, isWanted) {
    if (indexOfPhoto(this.#current?.face, photo) !== undefined || !(await openPicture(host, photo, isWanted))) return false;
    const detection = detectionOf(photo);
    await this.#changePhotos(host, (studio) => studio.addPhoto(...detection), (photos) => [...photos, photo]);
    return true;
  }

  /**
   * Changes the photos of the open face in the studio, the saved work and the display.
   *
   * @param {Host} host
   * @param {(studio: import("../wasm/rosto-studio-web.js").Studio) => import("../wasm/rosto-studio-web.js").ChangeName} act
   * @param {(photos: OpenedFace[]) => OpenedFace[]} change
   */
  async #changePhotos(host, act, change) {
    const { overlay, autosave, faceChoice } = this.#context;
    const before = this.#current;
    if (!before) return;
    const { face: previous, faces } = before;
    const lens = host.ask((studio) => studio.photoLens);
    host.attempt(act);
    const place = host.ask((studio) => photoFacts(studio).findIndex(({ leads }) => leads)) ?? 0;
    // When another photo becomes the lead photo, the previous one keeps the lens that the user set.
    const withLens = photosOf(previous).map((photo, at) => (at === (previous.place ?? 0) && lens !== undefined ? { ...photo, lens } : photo));
    const isSameLead = change(photosOf(previous))[place]?.landmarks === previous.landmarks;
    const face = faceFromPhotos(change(isSameLead ? photosOf(previous) : withLens), place, previous.name);
    autosave.replaceFace(face);
    this.#current = { face, faces: isSameLead ? faces.map((other) => (other === previous ? face : other)) : [face] };
    // Listeners read the photos of the texture, which have just changed.
    host.announce();
    await nextTask();
    const { faces: shown } = this.#current;
    try {
      const bitmap = await bitmapOf(face);
      overlay.show(await overlay.prepare(face, bitmap));
      await faceChoice.show(shown, recentFaces(this.#earlier, shown), bitmap);
      bitmap.close();
    } catch (error) {
      // The face itself has changed; only the display of its photo failed.
      showError({ code: "photo-not-shown", message: String(error), hint: "" });
    }
  }

  /**
   * @param {ShownFace | undefined} shown earlier in this visit
   * @returns {Promise<Incoming>}
   */
  async #reopen(shown) {
    if (!shown || shown.face === this.#current?.face) throw new Replaced();
    return fromVisit(shown, this.#context.autosave.lastEditsOf(shown.face));
  }

  /**
   * Runs `act` after the changes queued before it.
   *
   * @template T
   * @param {() => Promise<T>} act
   * @returns {Promise<T>}
   */
  #enqueue(act) {
    const done = this.#queue.then(act);
    this.#queue = done.catch(() => {});
    return done;
  }

  /**
   * Opens a face in the studio, atomically and as the last step that can fail. The pixels, the face and the photo panel
   * are updated in separate tasks to keep the page responsive.
   *
   * @param {Incoming} incoming
   * @param {() => boolean} isWanted
   */
  async #install({ face, faces, bitmap, edits }, isWanted) {
    const { host, overlay, autosave } = this.#context;
    const opened = await host;
    const photos = photosOf({ ...face, lens: edits?.lens ?? face.lens });
    if (opened && !(await openPictures(opened, photos, isWanted))) return false;
    const prepared = await overlay.prepare(face, bitmap);
    if (!isWanted()) {
      prepared.part.close();
      return false;
    }
    // Save an edit in progress too.
    opened?.act((studio) => studio.commit());
    autosave.flush();
    if (opened) openFace(opened, photos, edits);
    if (opened) autosave.start(face);
    this.#earlier = shownBefore([this.#current, ...this.#earlier], face);
    this.#current = { face, faces };
    await nextTask();
    overlay.show(prepared);
    return true;
  }

  /** @param {Incoming} incoming */
  #onOpened({ faces, bitmap, extraction_ms, changedElsewhere, isDoubtful, ofThisVisit = false }) {
    const { host, opened, faceChoice } = this.#context;
    document.body.dataset["state"] = document.body.dataset["host"] === "open" ? "face" : "photo";
    byId("welcome", HTMLElement).hidden = true;
    byId("toolbar", HTMLDivElement).hidden = document.body.dataset["host"] !== "open";
    // Collapse the photo to make room for the tools; without a 3D view, keep it open.
    byId("section-photo", HTMLDetailsElement).open = document.body.dataset["state"] === "photo";
    faceChoice.show(faces, recentFaces(this.#earlier, faces), bitmap).catch((error) => console.warn("cannot show the recent faces:", error));
    resetPanel(ofThisVisit);
    // Fields that were being typed in can be updated again.
    host.then((ready) => ready?.announce());
    opened(extraction_ms);
    if (changedElsewhere) showError({ code: "changed-elsewhere", message: "", hint: "" });
    else if (isDoubtful) showRemark("may-not-be-a-face", {});
    else if (document.body.dataset["host"] === "open") showHints();
  }
}
