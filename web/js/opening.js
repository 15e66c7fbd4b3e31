import { byId } from "./page/dom.js";
import { freshen } from "./page/fresh.js";
import { giveHints } from "./page/hint.js";
import { dismissNotices, showError, showNotAdded, showRemark } from "./page/notice.js";
import { hideProgress } from "./page/progress.js";
import { nextTask } from "./page/tasks.js";
import { openPicture, openPictures, takeFace } from "./photo/open-picture.js";
import { readPhoto } from "./photo/read-photo.js";
import { Replaced } from "./photo/vision-client.js";
import { isTrap } from "./viewport/studio-module.js";
import { stemOf } from "./work/file-name.js";
import { fromVisit, fromWork, shownBefore, recentFaces } from "./work/incoming.js";
import { faceOf, factsOf, foundIn, photosOf, placeOf } from "./work/photos.js";
import { bitmapOf } from "./work/pixels.js";
import { kindOf, readSavedFile } from "./work/saved-file.js";

/**
 * @typedef {import("./viewport/host.js").Host} Host
 * @typedef {import("./work/work.js").Work} Work
 * @typedef {import("./work/work.js").OpenedFace} OpenedFace
 * @typedef {import("./work/incoming.js").Shown} Shown
 * @typedef {import("./work/incoming.js").Incoming} Incoming
 *
 * @typedef {object} Room where a face is shown
 * @property {Promise<Host | undefined>} host nothing where the browser cannot draw in 3D
 * @property {import("./photo/photo-overlay.js").PhotoOverlay} overlay
 * @property {import("./photo/face-choice.js").FaceChoice} faceChoice
 * @property {import("./photo/vision-client.js").VisionClient} vision
 * @property {import("./work/autosave.js").Autosave} autosave
 * @property {(extraction_ms: number | undefined) => void} opened
 */

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
  /** @type {Shown | undefined} */
  #now;
  /** What was shown before, the latest first, which can be gone back to. @type {Shown[]} */
  #before = [];

  /** @param {Room} room */
  constructor(room) {
    this.#room = room;
  }

  /** Lens data of the photo on the screen. */
  get lens() {
    return this.#now?.face.lens;
  }

  /** The face on the screen. */
  get face() {
    return this.#now?.face;
  }

  /**
   * A photo, or a project or GLB that was saved before.
   *
   * @param {Blob | Promise<Blob>} file
   * @param {string} [name] instead of the file's own
   */
  openFile(file, name) {
    return this.#open(async (isWanted) => {
      const blob = await file;
      // The page's own module, which reads saved files, may still be on its way.
      const host = await this.#room.host;
      const kind = host ? await kindOf(blob) : "other";
      if (!isWanted()) throw new Replaced();
      if (kind === "other") return readPhoto(this.#room.vision, blob, name ?? stemOf(blob), isWanted);
      return fromWork(await readSavedFile(blob, kind));
    });
  }

  /**
   * A frame of the mirror, with what was done to the face in it.
   *
   * @param {Blob} photo
   * @param {import("./work/work.js").Done} [done]
   */
  openFrame(photo, done) {
    return this.#open(async (isWanted) => {
      const incoming = await readPhoto(this.#room.vision, photo, "selfie", isWanted);
      return done ? { ...incoming, done } : incoming;
    });
  }

  /**
   * Another face of the photo that is open. One of a photo that is open no more is not opened.
   *
   * @param {OpenedFace} face
   */
  openFace(face) {
    const { faces = [] } = this.#now ?? {};
    return this.#open(() => this.#again(faces.includes(face) ? { face, faces } : undefined));
  }

  /**
   * A face that was shown before this one.
   *
   * @param {OpenedFace} face
   */
  goBackTo(face) {
    return this.#open(() => this.#again(this.#before.find((shown) => shown.face === face)));
  }

  /**
   * Further photos of the face that is open. Those that cannot be added are named, and the others are added.
   *
   * @param {File[]} files
   */
  addPhotos(files) {
    return this.#attend(async (isWanted) => {
      const host = await this.#room.host;
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
   * Takes one of the photos away from the face that is open. Where it is by then is looked up when its turn has come: one that
   * is gone already is not taken away twice.
   *
   * @param {OpenedFace} photo
   */
  removePhoto(photo) {
    return this.#attend(async () => {
      const host = await this.#room.host;
      if (!host) return;
      await this.#inTurn(async () => {
        const place = placeOf(this.#now?.face, photo);
        if (place === undefined) return;
        await this.#changePhotos(host, (studio) => studio.removePhoto(place), (photos) => photos.toSpliced(place, 1));
      });
    });
  }

  /**
   * Brings a photo back that was taken away from the face that is open.
   *
   * @param {OpenedFace} photo
   */
  restorePhoto(photo) {
    return this.#attend(async (isWanted) => {
      const host = await this.#room.host;
      if (host) await this.#inTurn(() => this.#seeIn(host, photo, isWanted));
    });
  }

  /**
   * Work that was kept.
   *
   * @param {() => Promise<Work>} read
   */
  openWork(read) {
    return this.#open(async () => fromWork(await read()));
  }

  /**
   * Brings work back to a studio that has lost it.
   *
   * @param {Work} work
   */
  async restore(work) {
    const ticket = ++this.#newest;
    const { faces = [work.face] } = this.#now ?? {};
    const incoming = { ...(await fromWork(work)), faces };
    await this.#inTurn(() => this.#bringIn(incoming, () => ticket === this.#newest));
  }

  /** @param {(isWanted: () => boolean) => Promise<Incoming>} read */
  #open(read) {
    return this.#attend(async (isWanted) => {
      const incoming = await read(isWanted);
      const isOpen = isWanted() && (await this.#inTurn(() => this.#bringIn(incoming, isWanted)));
      if (isOpen) this.#welcome(incoming);
      incoming.bitmap.close();
    });
  }

  /**
   * Does what is wanted now, in place of what was on its way.
   *
   * @param {(isWanted: () => boolean) => Promise<void>} act
   */
  async #attend(act) {
    const ticket = ++this.#newest;
    const isWanted = () => ticket === this.#newest;
    dismissNotices();
    hideProgress();
    try {
      await act(isWanted);
    } catch (error) {
      if (isTrap(error)) (await this.#room.host)?.fail(error);
      else if (isWanted() && !(error instanceof Replaced)) showError(error);
    } finally {
      if (isWanted()) hideProgress();
      this.#room.faceChoice.mark(this.#now?.face);
    }
  }

  /**
   * @param {Host} host
   * @param {File} file
   * @param {() => boolean} isWanted
   */
  async #addPhoto(host, file, isWanted) {
    const most = host.ask((studio) => studio.mostPhotos) ?? 1;
    if (this.#now && photosOf(this.#now.face).length >= most) throw { code: "too-many-photos", message: `${most} photos`, hint: "" };
    if ((await kindOf(file)) !== "other") throw { code: "not-a-picture", message: "a saved face", hint: "" };
    const { face: photo, bitmap } = await readPhoto(this.#room.vision, file, stemOf(file), isWanted);
    bitmap.close();
    await this.#inTurn(async () => {
      if (!(await this.#seeIn(host, photo, isWanted))) return;
      const adds = host.ask((studio) => factsOf(studio).at(-1)?.adds);
      if (adds === false) showRemark("adds-little", { name: file.name });
    });
  }

  /**
   * The open face in one more photo, unless it is in it already. Resolves to whether it is new.
   *
   * @param {Host} host
   * @param {OpenedFace} photo
   * @param {() => boolean} isWanted
   */
  async #seeIn(host, photo, isWanted) {
    if (placeOf(this.#now?.face, photo) !== undefined || !(await openPicture(host, photo, isWanted))) return false;
    const found = foundIn(photo);
    await this.#changePhotos(host, (studio) => studio.addPhoto(...found), (photos) => [...photos, photo]);
    return true;
  }

  /**
   * The open face in other photos: in the studio, in what is kept, and in what is shown of it.
   *
   * @param {Host} host
   * @param {(studio: import("../wasm/rosto-studio-web.js").Studio) => import("../wasm/rosto-studio-web.js").ChangeName} act
   * @param {(photos: OpenedFace[]) => OpenedFace[]} change
   */
  async #changePhotos(host, act, change) {
    const { overlay, autosave, faceChoice } = this.#room;
    const before = this.#now;
    if (!before) return;
    const { face: was, faces } = before;
    const lens = host.ask((studio) => studio.photoLens);
    host.attempt(act);
    const place = host.ask((studio) => factsOf(studio).findIndex(({ leads }) => leads)) ?? 0;
    // The one that led is taken to be taken as it was said.
    const asSaid = photosOf(was).map((photo, at) => (at === (was.place ?? 0) && lens !== undefined ? { ...photo, lens } : photo));
    const isSameLead = change(photosOf(was))[place]?.landmarks === was.landmarks;
    const face = faceOf(change(isSameLead ? photosOf(was) : asSaid), place, was.name);
    autosave.change(face);
    this.#now = { face, faces: isSameLead ? faces.map((one) => (one === was ? face : one)) : [face] };
    // Only now is known of which photos its texture is made.
    host.announce();
    await nextTask();
    const { faces: shown } = this.#now;
    try {
      const bitmap = await bitmapOf(face);
      overlay.show(await overlay.prepare(face, bitmap));
      await faceChoice.show(shown, recentFaces(this.#before, shown), bitmap);
      bitmap.close();
    } catch (error) {
      // The face is another one already: only what is seen of its photo is not.
      showError({ code: "photo-not-shown", message: String(error), hint: "" });
    }
  }

  /**
   * @param {Shown | undefined} shown in this visit
   * @returns {Promise<Incoming>}
   */
  async #again(shown) {
    if (!shown || shown.face === this.#now?.face) throw new Replaced();
    return fromVisit(shown, this.#room.autosave.doneTo(shown.face));
  }

  /**
   * @template T
   * @param {() => Promise<T>} act
   * @returns {Promise<T>}
   */
  #inTurn(act) {
    const done = this.#last.then(act);
    this.#last = done.catch(() => {});
    return done;
  }

  /**
   * Hands a face to the studio, which takes it whole or not at all, last of all that can fail. The photo on the panel, its
   * pixels and the face each have a task of their own, so that none keeps the page waiting.
   *
   * @param {Incoming} incoming
   * @param {() => boolean} isWanted
   */
  async #bringIn({ face, faces, bitmap, done }, isWanted) {
    const { host, overlay, autosave } = this.#room;
    const opened = await host;
    const photos = photosOf({ ...face, lens: done?.lens ?? face.lens });
    if (opened && !(await openPictures(opened, photos, isWanted))) return false;
    const prepared = await overlay.prepare(face, bitmap);
    if (!isWanted()) {
      prepared.part.close();
      return false;
    }
    // An edit in progress is one, too.
    opened?.act((studio) => studio.commit());
    autosave.finish();
    if (opened) takeFace(opened, photos, done);
    if (opened) autosave.take(face);
    this.#before = shownBefore([this.#now, ...this.#before], face);
    this.#now = { face, faces };
    await nextTask();
    overlay.show(prepared);
    return true;
  }

  /** @param {Incoming} incoming that is open now */
  #welcome({ faces, bitmap, extraction_ms, changedElsewhere, isDoubtful, ofThisVisit = false }) {
    const { host, opened, faceChoice } = this.#room;
    document.body.dataset["state"] = document.body.dataset["host"] === "open" ? "face" : "photo";
    byId("welcome", HTMLElement).hidden = true;
    byId("toolbar", HTMLDivElement).hidden = document.body.dataset["host"] !== "open";
    // The tools take the place of the photo, which folds to a row; without a view in 3D it is all there is to see.
    byId("section-photo", HTMLDetailsElement).open = document.body.dataset["state"] === "photo";
    faceChoice.show(faces, recentFaces(this.#before, faces), bitmap).catch((error) => console.warn("the faces are not shown:", error));
    freshen(ofThisVisit);
    // What was being typed no longer stands in the way of what is to be shown.
    host.then((there) => there?.announce());
    opened(extraction_ms);
    if (changedElsewhere) showError({ code: "changed-elsewhere", message: "", hint: "" });
    else if (isDoubtful) showRemark("may-not-be-a-face", {});
    else if (document.body.dataset["host"] === "open") giveHints();
  }
}
