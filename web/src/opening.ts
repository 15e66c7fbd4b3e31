import { asPageError, noFace } from "./page/page-error.ts";
import { nextTask } from "./page/tasks.ts";
import { isTrap } from "./studio-module.ts";
import { facesOf, filesWith, nameIn, photoOf } from "./work/face.ts";
import type { VisionClient } from "./photo/vision-client.ts";
import type { Host } from "./viewport/host.ts";
import type { Face, FacePhoto, SourceFile } from "./work/face.ts";
import type { Stage } from "./worker/protocol.ts";
import type { Changed, Studio } from "../wasm/rosto-studio-web.js";

export interface ShownFace {
  face: Face;
  /** all faces of the photo, including `face` */
  faces: Face[];
}

/** `instance`: of the studio that shows the face */
type Current = ShownFace & { host?: Host; instance?: object };

export interface Incoming extends ShownFace {
  /** the face's pictures; those that the studio has taken are removed */
  bitmaps: ImageBitmap[];
  /** to restore; otherwise, the current settings and view stay */
  preferences?: string | undefined;
  /** time to find the landmarks */
  extraction_ms?: number | undefined;
  /** another program has changed the mesh in the file */
  changedElsewhere?: boolean;
  /** the photo was open before */
  ofThisVisit?: boolean;
}

export interface Display {
  show: () => void;
  discard: () => void;
}

export interface Listeners {
  /** a request has begun */
  begun?: () => void;
  progress?: (stage: Stage | "loading", fraction: number) => void;
  /** prepares the display of the lead photo; the last step that can fail before the face opens */
  prepare?: (shown: ShownFace, picture: ImageBitmap) => Promise<Display>;
  /** the studio shows this face */
  started?: (face: Face) => void;
  opened?: (incoming: Incoming) => void;
  photosChanged?: () => void;
  addedLittle?: (name: string) => void;
  /** after a trap too; `photo`: name of a photo that was not added */
  failed?: (error: unknown, photo?: string) => void;
  /** a request has ended; `isNewest`: no newer one has begun */
  ended?: (isNewest: boolean) => void;
}

/** Number of earlier photos whose faces are offered. */
export const MAX_EARLIER_PHOTOS = 9;

/** Saved files, which open without face detection. */
const SAVED_NAME = /\.(glb|rosto)$/i;

/** Errors that do not depend on the file. */
const WORKER_CODES = new Set(["worker-died", "not-loaded"]);

/**
 * Single entry point for photos, files, the camera, the sample and restored work. A newer request cancels the pending
 * one. A face replaces the current one only after it was read and checked, so a failure leaves the current and the
 * saved work unchanged.
 */
export class Opening {
  /** The newest request. */
  #request = new AbortController();
  /** Queue: a change takes several tasks, and changes must not interleave. */
  #queue: Promise<unknown> = Promise.resolve();
  #host;
  #vision;
  #listeners;
  #current: Current | undefined;
  /** Faces shown before, latest first. */
  #earlier: ShownFace[] = [];

  /** @param host undefined if the browser cannot draw in 3D */
  constructor(host: Promise<Host | undefined>, vision: VisionClient, listeners: Listeners) {
    this.#host = host;
    this.#vision = vision;
    this.#listeners = listeners;
    host.then((opened) => opened?.onRestart(() => this.#restore()));
  }

  /** The open face. */
  get face() {
    return this.#current?.face;
  }

  /** All faces of the photo, most prominent first. */
  get faces() {
    return this.#current?.faces ?? [];
  }

  /** Number of photos that a face can have. */
  get maxPhotos() {
    return this.#host.then((host) => host?.catalogue.maxPhotos ?? 1);
  }

  /** The face shown last of each other photo, latest first. */
  get recent() {
    const others = this.#earlier.map(({ face }) => face).filter((face) => !this.faces.includes(face));
    const latest = new Map(others.toReversed().map((face) => [photoKey(face), face]));
    return others.filter((face) => latest.get(photoKey(face)) === face);
  }

  /** The open face with its current photos and edits; as last read while the studio restarts after a crash. */
  remember() {
    const { face, host, instance } = this.#current ?? {};
    if (!face || !host || host.instance !== instance) return face;
    const now = host.read((state, studio) => {
      const lead = state.photos.findIndex(({ leads }) => leads);
      const texts = { photos: studio.savedPhotos(), edits: studio.savedEdits(), preferences: state.preferences };
      return { ...texts, pictures: studio.pictures(), lead };
    });
    return Object.assign(face, now);
  }

  /**
   * Opens a photo, project or GLB.
   *
   * @param name overrides the file's name
   * @param edits to be applied to the face
   */
  openFile(file: Blob | Promise<Blob>, name?: string, edits?: string) {
    return this.#run(async (signal) => {
      const blob = await file;
      signal.throwIfAborted();
      const incoming = await this.#read(blob, signal, name);
      if (edits !== undefined) incoming.face.edits = edits;
      await this.#open(incoming, signal);
    });
  }

  /** Opens photos of different people, the first one last, so that it stays. Reports each photo that cannot be opened. */
  openEach(photos: File[]) {
    return this.#run(async (signal) => {
      for (const photo of photos.slice(0, 1 + MAX_EARLIER_PHOTOS).reverse()) {
        await this.#orReport(photo, signal, async () => this.#open(await this.#read(photo, signal), signal));
      }
    });
  }

  /** Opens the first photo that has a face, and adds the others to it. Reports each photo that cannot be used. */
  openTogether(photos: File[]) {
    return this.#run(async (signal) => {
      const max = await this.maxPhotos;
      let face: Face | undefined;
      for (const photo of photos) {
        if ((face?.pictures.length ?? 0) >= max) break;
        await this.#orReport(photo, signal, async () => {
          if (face) return this.#addPhoto(photo, signal);
          await this.#open(await this.#read(photo, signal), signal);
          face = this.face;
        });
      }
    });
  }

  /** Opens another face of the current photo, or returns to a face shown earlier; ignores other faces. */
  openFace(face: Face) {
    return this.#run(async (signal) => {
      const shown = [{ face, faces: this.faces }, ...this.#earlier].find(({ faces }) => faces.includes(face));
      if (!shown || face === this.face) return;
      await this.#open({ face, faces: shown.faces, bitmaps: await this.#bitmapsOf(face), ofThisVisit: true }, signal);
    });
  }

  /** Opens saved work. */
  openWork(read: () => Promise<Face>) {
    return this.#run(async (signal) => {
      const face = await read();
      const bitmaps = await this.#bitmapsOf(face).catch((error) => {
        const { code, message } = asPageError(error);
        throw WORKER_CODES.has(code) ? error : { code: "bad-kept-work", message, hint: "" };
      });
      await this.#open({ face, faces: [face], bitmaps, preferences: face.preferences }, signal);
    });
  }

  /** Adds further photos of the open face. Reports each photo that cannot be added. */
  addPhotos(files: File[]) {
    return this.#run(async (signal) => {
      for (const file of files) await this.#orReport(file, signal, () => this.#addPhoto(file, signal));
    });
  }

  /**
   * Removes a photo from the open face. Its index is looked up when the queue reaches it, as earlier changes may move
   * or remove it.
   */
  removePhoto(picture: string) {
    return this.#run(() => this.#enqueue(async () => {
      const index = this.face?.pictures.indexOf(picture) ?? -1;
      if (index >= 0) await this.#changePhotos((studio) => studio.removePhoto(index));
    }));
  }

  /** Restores a photo removed from the open face. */
  restorePhoto(photo: FacePhoto) {
    return this.#run(async (signal) => {
      const bitmaps = await this.#bitmapsOf(photo);
      await this.#enqueue(() => this.#addFound(photo, bitmaps, signal));
    });
  }

  /** Cancels the pending request. */
  cancel() {
    this.#request.abort();
  }

  /** Shows the face again after the studio has crashed. */
  async #restore() {
    const { face, faces } = this.#current ?? {};
    if (!face || !faces) return;
    this.cancel();
    try {
      await this.#enqueue(async () => {
        const bitmaps = await this.#bitmapsOf(face);
        // A later request follows in the queue and may fail, so this one is not cancelled.
        await this.#install({ face, faces, bitmaps, preferences: face.preferences }, new AbortController().signal);
      });
    } finally {
      this.#listeners.ended?.(true);
    }
  }

  /** Runs a request, cancels the pending one and reports errors. */
  async #run(act: (signal: AbortSignal) => Promise<unknown>) {
    this.cancel();
    this.#request = new AbortController();
    const { signal } = this.#request;
    this.#listeners.begun?.();
    try {
      await act(signal);
    } catch (error) {
      if (!signal.aborted) this.#listeners.failed?.(error);
    } finally {
      this.#listeners.ended?.(!signal.aborted);
    }
  }

  /** Uses one of several photos. Reports a failure, and goes on. */
  async #orReport(photo: File, signal: AbortSignal, use: () => Promise<void>) {
    signal.throwIfAborted();
    await use().catch((error) => {
      if (isTrap(error) || signal.aborted) throw error;
      this.#listeners.failed?.(error, photo.name);
    });
  }

  /** Runs `act` after the changes queued before it. */
  #enqueue<T>(act: () => Promise<T>): Promise<T> {
    const done = this.#queue.then(act);
    this.#queue = done.catch(() => {});
    return done;
  }

  async #read(file: Blob, signal: AbortSignal, name?: string): Promise<Incoming> {
    const { progress } = this.#listeners;
    if (!(file instanceof File && SAVED_NAME.test(file.name))) progress?.("loading", 0);
    // Measure from the first progress report, so that loading the worker does not count.
    let begun_ms: number | undefined;
    const read = await this.#vision.open(file, (stage, fraction) => {
      begun_ms ??= performance.now();
      if (!signal.aborted) progress?.(stage, fraction);
    });
    const { bitmaps, opened: { kind, changedElsewhere, faces: [found] } } = read;
    const defaultDensity = (await this.#host)?.catalogue.defaultDensity;
    const faces = facesOf(read, name ?? nameIn(file, found?.edits, defaultDensity));
    const [face] = faces;
    if (!found || !face) throw noFace();
    const extraction_ms = kind === "photo" && begun_ms !== undefined ? performance.now() - begun_ms : undefined;
    return { face, faces, bitmaps, changedElsewhere, extraction_ms };
  }

  #bitmapsOf({ pictures, files }: FacePhoto) {
    return Promise.all(pictures.map((picture) => this.#vision.request("picture", { picture, files })));
  }

  async #open(incoming: Incoming, signal: AbortSignal) {
    await this.#enqueue(() => this.#install(incoming, signal));
    this.#listeners.opened?.(incoming);
  }

  /** Opens a face in the studio, atomically and as the last step that can fail. */
  async #install({ face, faces, bitmaps, preferences }: Incoming, signal: AbortSignal) {
    const host = await this.#host;
    let display: Display | undefined;
    try {
      signal.throwIfAborted();
      const picture = bitmaps[face.lead];
      if (!picture) throw new Error("no picture of the lead photo");
      display = await this.#listeners.prepare?.({ face, faces }, picture);
      signal.throwIfAborted();
      if (host) await this.#show(host, { face, faces, bitmaps }, signal);
      else this.#setCurrent({ face, faces });
    } catch (error) {
      display?.discard();
      throw error;
    } finally {
      closeAll(bitmaps);
    }
    if (preferences) host?.apply({ "restore-preferences": preferences });
    this.remember();
    if (host) this.#listeners.started?.(face);
    await nextTask();
    display?.show();
  }

  /** Opens a face in the studio. */
  async #show(host: Host, { face, faces, bitmaps }: Incoming, signal: AbortSignal) {
    await this.#addPictures(host, face.pictures, bitmaps, signal);
    // Save an edit in progress too.
    host.apply("commit");
    this.remember();
    host.perform((studio) => {
      const changed = studio.open(face.photos, face.edits, face.pictures);
      // Before the studio's listeners run.
      this.#setCurrent({ face, faces, host, instance: host.instance });
      return changed;
    });
  }

  #setCurrent(next: Current) {
    const shown = this.#current ? [this.#current, ...this.#earlier] : [];
    const before = shown.filter(({ face }) => face !== next.face);
    const photos = new Set([next, ...before].map(({ face }) => photoKey(face)));
    const offered = [...photos].slice(0, 1 + MAX_EARLIER_PHOTOS);
    this.#earlier = before.filter(({ face }) => offered.includes(photoKey(face)));
    this.#current = next;
  }

  /**
   * Passes pictures to the studio, which then owns them, and removes them from `bitmaps`. Each is uploaded in its own
   * task to keep the page responsive.
   */
  async #addPictures(host: Host, pictures: string[], bitmaps: ImageBitmap[], signal: AbortSignal) {
    for (const picture of pictures) {
      signal.throwIfAborted();
      const [bitmap] = bitmaps;
      if (bitmap) host.answer((studio) => studio.addPicture(picture, bitmap));
      bitmaps.shift();
      await nextTask();
    }
    signal.throwIfAborted();
  }

  async #addPhoto(file: File, signal: AbortSignal) {
    const host = await this.#host;
    const max = await this.maxPhotos;
    const count = this.face?.pictures.length ?? 0;
    if (count >= max) throw { code: "too-many-photos", message: `${max} photos`, hint: "" };
    const { face, bitmaps } = await this.#read(file, signal);
    if (face.files[0]?.kind === "saved") {
      closeAll(bitmaps);
      throw { code: "not-a-picture", message: "a saved face", hint: "" };
    }
    await this.#enqueue(() => this.#addFound(face, bitmaps, signal));
    if (host?.read(({ photos }) => photos.at(-1)?.adds) === false) this.#listeners.addedLittle?.(file.name);
  }

  /** Adds a photo whose landmarks are known; no-op if the face has it already. */
  async #addFound({ photos, pictures, files }: FacePhoto, bitmaps: ImageBitmap[], signal: AbortSignal) {
    const { face, host } = this.#current ?? {};
    const [picture = ""] = pictures;
    try {
      if (!face || !host || face.pictures.includes(picture)) return;
      await this.#addPictures(host, [picture], bitmaps, signal);
    } finally {
      closeAll(bitmaps);
    }
    await this.#changePhotos((studio) => studio.addPhoto(photos, picture), files);
  }

  /** Changes the photos of the open face in the studio, the saved work and the display. */
  async #changePhotos(act: (studio: Studio) => Changed, added: SourceFile[] = []) {
    const current = this.#current;
    if (!current?.host) return;
    const { face, host } = current;
    const leadBefore = face.pictures[face.lead];
    host.perform((studio) => {
      const changed = act(studio);
      // Before the studio's listeners run.
      this.remember();
      face.files = filesWith([...face.files, ...added], face.pictures);
      return changed;
    });
    const lead = face.pictures[face.lead];
    if (lead !== leadBefore) current.faces = [face];
    this.#listeners.photosChanged?.();
    if (lead === leadBefore || lead === undefined) return;
    let bitmaps: ImageBitmap[] = [];
    try {
      bitmaps = await this.#bitmapsOf(photoOf(face, lead));
      const [bitmap] = bitmaps;
      if (bitmap) (await this.#listeners.prepare?.(current, bitmap))?.show();
    } catch (error) {
      // The face itself has changed; only the display of its photo failed.
      this.#listeners.failed?.({ code: "photo-not-shown", message: String(error), hint: "" });
    } finally {
      closeAll(bitmaps);
    }
  }
}

function closeAll(bitmaps: ImageBitmap[]) {
  for (const bitmap of bitmaps) bitmap.close();
}

/** Identifies the first photo of a face. */
function photoKey({ files }: Face) {
  return files[0]?.key;
}
