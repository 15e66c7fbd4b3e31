import { asPageError, noFace } from "./page/page-error.ts";
import { nextTask } from "./page/tasks.ts";
import { isTrap } from "./studio-module.ts";
import { facesOf, filesWith, nameIn, photoOf } from "./work/face.ts";
import { shownBefore } from "./work/recent-faces.ts";
import type { Host,  } from "./viewport/host.ts";
import type { Face, FacePhoto, SourceFile } from "./work/face.ts";
import type { ShownFace } from "./work/recent-faces.ts";
import type { Stage } from "./worker/protocol.ts";
import type { Changed, Studio } from "../wasm/rosto-studio-web.js";
import type { VisionClient } from "./photo/vision-client.ts";

export interface Loaded {
  /** the face's pictures */
  bitmaps: ImageBitmap[];
  /** to restore; otherwise, the current settings and view stay */
  preferences?: string;
  /** time to find the landmarks */
  extraction_ms?: number;
  /** another program has changed the mesh in the file */
  changedElsewhere?: boolean;
  /** possibly not a face */
  isDoubtful?: boolean;
  /** the photo was open before */
  ofThisVisit?: boolean;
}

export type Incoming = ShownFace & Loaded;

export type Display = { show: () => void; discard: () => void; };

export type Current = ShownFace & { host?: Host; instance?: object; };

export interface Listeners {
  /** a request has begun */
  begun: () => void;
  progress: (stage: Stage | "loading", fraction: number) => void;
  /** prepares the display of the lead photo; the last step that can fail before the face opens */
  prepare: (shown: ShownFace, picture: ImageBitmap) => Promise<Display>;
  /** another face is about to replace the current one */
  leaving: () => void;
  /** the studio shows this face */
  started: (face: Face) => void;
  opened: (incoming: Incoming) => void;
  photosChanged: (shown: ShownFace) => void;
  notAdded: (name: string, error: unknown) => void;
  addedLittle: (name: string) => void;
  /** after a trap too */
  failed: (error: unknown) => void;
  /** a request has ended; `isNewest`: no newer one has begun */
  ended: (isNewest: boolean) => void;
}

const NO_LISTENERS: Listeners = {
  ...{ begun: () => {}, progress: () => {}, prepare: async () => ({ show: () => {}, discard: () => {} }) },
  ...{ leaving: () => {}, started: () => {}, opened: () => {}, photosChanged: () => {} },
  ...{ notAdded: () => {}, addedLittle: () => {}, failed: () => {}, ended: () => {} },
};

/** Saved files, which open without face detection. */
const SAVED_NAME = /\.(glb|rosto)$/i;

/** Errors that do not depend on the file. */
const WORKER_CODES = new Set(["worker-died", "not-loaded"]);

/** Rejection reason when a newer request supersedes this one. */
export class Replaced extends Error {}

/**
 * Single entry point for photos, files, the camera, the sample and restored work. A newer request cancels the pending
 * one. A face replaces the current one only after it was read and checked, so a failure leaves the current and the
 * saved work unchanged.
 */
export class Opening {
  #newest = 0;
  /** Queue: a change takes several tasks, and changes must not interleave. */
  #queue: Promise<unknown> = Promise.resolve();
  #host;
  #vision;
  #listeners;
  #current: Current | undefined;
  /** Faces shown before, latest first. */
  #earlier: ShownFace[] = [];

  /** @param host undefined if the browser cannot draw in 3D */
  constructor(host: Promise<Host | undefined>, vision: VisionClient, listeners: Partial<Listeners>) {
    this.#host = host;
    this.#vision = vision;
    this.#listeners = { ...NO_LISTENERS, ...listeners };
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

  /** The faces shown before, latest first. */
  get earlier() {
    return this.#earlier;
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
    return this.#open(async (isWanted) => {
      const blob = await file;
      if (!isWanted()) throw new Replaced();
      const incoming = await this.#read(blob, isWanted, name);
      if (edits !== undefined) incoming.face.edits = edits;
      return incoming;
    });
  }

  /** Opens another face of the current photo, or returns to a face shown earlier; ignores other faces. */
  openFace(face: Face) {
    return this.#open(async () => {
      const isOfPhoto = this.faces.includes(face);
      const shown = isOfPhoto ? { face, faces: this.faces } : this.#earlier.find((shown) => shown.face === face);
      if (!shown || face === this.face) throw new Replaced();
      return { ...(await this.#withBitmaps(shown)), ofThisVisit: true };
    });
  }

  /** Opens saved work. */
  openWork(read: () => Promise<Face>) {
    return this.#open(async () => {
      const face = await read();
      try {
        return { ...(await this.#withBitmaps({ face, faces: [face] })), ...(face.preferences && { preferences: face.preferences }) };
      } catch (error) {
        const { code, message } = asPageError(error);
        throw WORKER_CODES.has(code) ? error : { code: "bad-kept-work", message, hint: "" };
      }
    });
  }

  /** Adds further photos of the open face. Reports each photo that cannot be added. */
  addPhotos(files: File[]) {
    return this.#run(async (isWanted) => {
      for (const file of files) {
        if (!isWanted()) return;
        await this.#addPhoto(file, isWanted).catch((error) => {
          if (isTrap(error) || !isWanted()) throw error;
          this.#listeners.notAdded(file.name, error);
        });
      }
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
    return this.#run(async (isWanted) => {
      const bitmaps = await this.#bitmapsOf(photo);
      await this.#enqueue(() => this.#addFound(photo, bitmaps, isWanted));
    });
  }

  /** Cancels the pending request. */
  cancel() {
    this.#newest += 1;
  }

  /** Shows the face again after the studio has crashed. */
  async #restore() {
    const { face, faces } = this.#current ?? {};
    if (!face || !faces) return;
    this.cancel();
    try {
      await this.#enqueue(async () => {
        const incoming = await this.#withBitmaps({ face, faces });
        // A later request follows in the queue and may fail, so this one is not cancelled.
        await this.#install({ ...incoming, ...(face.preferences && { preferences: face.preferences }) }, () => true);
      });
    } finally {
      this.#listeners.ended(true);
    }
  }

  #ticket() {
    const ticket = ++this.#newest;
    return () => ticket === this.#newest;
  }

  #open(read: (isWanted: () => boolean) => Promise<Incoming>) {
    return this.#run(async (isWanted) => {
      const incoming = await read(isWanted);
      await this.#enqueue(() => this.#install(incoming, isWanted));
      this.#listeners.opened(incoming);
    });
  }

  /**
   * Runs a request, cancels the pending one and reports errors.
   *
   * @param act `isWanted` returns false once a newer request has begun
   */
  async #run(act: (isWanted: () => boolean) => Promise<unknown>) {
    const isWanted = this.#ticket();
    this.#listeners.begun();
    try {
      await act(isWanted);
    } catch (error) {
      if (isWanted() && !(error instanceof Replaced)) this.#listeners.failed(error);
    } finally {
      this.#listeners.ended(isWanted());
    }
  }

  /** Runs `act` after the changes queued before it. */
  #enqueue<T>(act: () => Promise<T>): Promise<T> {
    const done = this.#queue.then(act);
    this.#queue = done.catch(() => {});
    return done;
  }

  /** Reads a file, and reports the progress while `isWanted` returns true. */
  async #read(file: Blob, isWanted: () => boolean, name?: string): Promise<Incoming> {
    if (!(file instanceof File && SAVED_NAME.test(file.name))) this.#listeners.progress("loading", 0);
    // Measure from the first progress report, so that loading the worker does not count.
    let begun_ms = NaN;
    const read = await this.#vision.open(file, (stage, fraction) => {
      if (Number.isNaN(begun_ms)) begun_ms = performance.now();
      if (isWanted()) this.#listeners.progress(stage, fraction);
    });
    const { bitmaps, opened: { kind, changedElsewhere, faces: [found] } } = read;
    const defaultDensity = (await this.#host)?.catalogue.defaultDensity;
    const faces = facesOf(read, name ?? nameIn(file, found?.edits, defaultDensity));
    const [face] = faces;
    if (!found || !face) throw noFace();
    const isMeasured = kind === "photo" && !Number.isNaN(begun_ms);
    const facts = isMeasured ? { extraction_ms: performance.now() - begun_ms } : {};
    return { face, faces, bitmaps, changedElsewhere, isDoubtful: found.isDoubtful, ...facts };
  }

  async #withBitmaps({ face, faces }: ShownFace) {
    return { face, faces, bitmaps: await this.#bitmapsOf(face) };
  }

  #bitmapsOf({ pictures, files }: FacePhoto) {
    return Promise.all(pictures.map((picture) => this.#vision.request("picture", { picture, files })));
  }

  /** Opens a face in the studio, atomically and as the last step that can fail. */
  async #install({ face, faces, bitmaps, preferences }: Incoming, isWanted: () => boolean) {
    const host = await this.#host;
    const picture = bitmaps[face.lead];
    if (!picture) throw new Error("no picture of the lead photo");
    if (!isWanted()) {
      closeAll(bitmaps);
      throw new Replaced();
    }
    const prepared = await this.#listeners.prepare({ face, faces }, picture).catch((error) => {
      closeAll(bitmaps);
      throw error;
    });
    try {
      if (host) await this.#show(host, { face, faces, bitmaps }, isWanted);
      else if (!isWanted()) throw new Replaced();
    } catch (error) {
      prepared.discard();
      throw error;
    }
    if (!host) {
      closeAll(bitmaps);
      this.#setCurrent({ face, faces });
    }
    if (preferences) host?.apply({ "restore-preferences": preferences });
    this.remember();
    await nextTask();
    prepared.show();
  }

  /** Opens a face in the studio. Each picture is uploaded in its own task to keep the page responsive. */
  async #show(host: Host, { face, faces, bitmaps }: Incoming, isWanted: () => boolean) {
    await this.#addPictures(host, face.pictures, bitmaps, isWanted);
    // Save an edit in progress too.
    host.apply("commit");
    this.remember();
    this.#listeners.leaving();
    host.perform((studio) => {
      const changed = studio.open(face.photos, face.edits, face.pictures);
      // Before the studio's listeners run.
      this.#setCurrent({ face, faces, host, instance: host.instance });
      return changed;
    });
    this.#listeners.started(face);
  }

  #setCurrent(next: Current) {
    this.#earlier = shownBefore([this.#current, ...this.#earlier], next.face);
    this.#current = next;
  }

  /**
   * Passes pictures to the studio, which then owns them, and closes the others. Throws `Replaced` if the request was
   * cancelled.
   */
  async #addPictures(host: Host, pictures: string[], bitmaps: ImageBitmap[], isWanted: () => boolean) {
    const left = [...bitmaps];
    try {
      for (const [index, bitmap] of bitmaps.entries()) {
        if (!isWanted()) throw new Replaced();
        host.answer((studio) => studio.addPicture(pictures[index] ?? "", bitmap));
        left.shift();
        await nextTask();
      }
      if (!isWanted()) throw new Replaced();
    } finally {
      closeAll(left);
    }
  }

  async #addPhoto(file: File, isWanted: () => boolean) {
    const host = await this.#host;
    const max = host?.catalogue.maxPhotos ?? 1;
    if (this.face && this.face.pictures.length >= max) throw { code: "too-many-photos", message: `${max} photos`, hint: "" };
    const { face, bitmaps } = await this.#read(file, isWanted);
    if (face.files[0]?.kind === "saved") {
      closeAll(bitmaps);
      throw { code: "not-a-picture", message: "a saved face", hint: "" };
    }
    await this.#enqueue(() => this.#addFound(face, bitmaps, isWanted));
    if (host?.read(({ photos }) => photos.at(-1)?.adds) === false) this.#listeners.addedLittle(file.name);
  }

  /** Adds a photo whose landmarks are known; no-op if the face has it already. */
  async #addFound({ photos, pictures: [picture = ""], files }: FacePhoto, bitmaps: ImageBitmap[], isWanted: () => boolean) {
    const { face, host } = this.#current ?? {};
    if (!face || !host || face.pictures.includes(picture)) return closeAll(bitmaps);
    await this.#addPictures(host, [picture], bitmaps, isWanted);
    await this.#changePhotos((studio) => studio.addPhoto(photos, picture), files);
  }

  /** Changes the photos of the open face in the studio, the saved work and the display. */
  async #changePhotos(act: (studio: Studio) => Changed, added: SourceFile[] = []) {
    const { face, host } = this.#current ?? {};
    if (!this.#current || !face || !host) return;
    const leadBefore = face.pictures[face.lead];
    host.perform((studio) => {
      const changed = act(studio);
      // Before the studio's listeners run.
      this.remember();
      face.files = filesWith([...face.files, ...added], face.pictures);
      return changed;
    });
    const lead = face.pictures[face.lead];
    const isSameLead = lead === leadBefore;
    if (!isSameLead) this.#current = { ...this.#current, faces: [face] };
    const { faces } = this.#current;
    this.#listeners.photosChanged({ face, faces });
    if (isSameLead || lead === undefined) return;
    let bitmaps: ImageBitmap[] = [];
    try {
      bitmaps = await this.#bitmapsOf(photoOf(face, lead));
      const [bitmap] = bitmaps;
      if (bitmap) (await this.#listeners.prepare({ face, faces }, bitmap)).show();
    } catch (error) {
      // The face itself has changed; only the display of its photo failed.
      this.#listeners.failed({ code: "photo-not-shown", message: String(error), hint: "" });
    } finally {
      closeAll(bitmaps);
    }
  }
}

function closeAll(bitmaps: ImageBitmap[]) {
  for (const bitmap of bitmaps) bitmap.close();
}
