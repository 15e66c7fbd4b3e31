import { writeDraft } from "./drafts.ts";
import { lockSlot } from "./locks.ts";
import { SlotConflict, readSlot, writeSlot } from "./slots.ts";
import type { Work } from "./row-checks.ts";
import type { Face } from "./face.ts";

/** A face opened in this tab, with its slot in the database. */
export class StoredFace {
  readonly face: Face;
  #slot;
  /** Save order of the slot when this tab last wrote or read it. */
  #order: number | undefined;
  /** The part that is already in the database; the work as JSON. */
  #stored: { files?: Face["files"]; work?: string | undefined; } = {};
  #wantsLock = false;
  #release: (() => void) | undefined;
  #locking: Promise<void> = Promise.resolve();
  /** Serialises writes: one in progress, and one queued. */
  #writing: Promise<unknown> = Promise.resolve();
  #queued: Promise<boolean> | undefined;

  constructor(face: Face, slot: string = crypto.randomUUID()) {
    this.face = face;
    this.#slot = slot;
  }

  get slot() {
    return this.#slot;
  }

  /**
   * Locks and reads a slot.
   *
   * @returns undefined if another tab holds the lock
   */
  static async read(slot: string): Promise<StoredFace | undefined> {
    const release = await lockSlot(slot);
    if (!release) return undefined;
    try {
      const { face, order } = await readSlot(slot);
      const stored = new StoredFace(face, slot);
      stored.#stored = { files: face.files };
      stored.#order = order;
      [stored.#wantsLock, stored.#release] = [true, release];
      return stored;
    } catch (error) {
      release();
      throw error;
    }
  }

  /** Locks the slot, or a new one if another tab holds it. Writes wait for the lock. */
  lock() {
    this.#wantsLock = true;
    this.#locking = this.#locking.then(() => this.#lock());
  }

  /** Releases the lock, for other tabs. */
  unlock() {
    this.#wantsLock = false;
    this.#release?.();
    this.#release = undefined;
  }

  /** Forces the next save to write the slot even without changes. */
  markDirty() {
    this.#stored.work = undefined;
  }

  /**
   * Writes the unsaved changes.
   *
   * @returns whether the face itself was written
   */
  save(): Promise<boolean> {
    this.#queued ??= this.#writing.then(() => {
      this.#queued = undefined;
      return this.#write();
    });
    this.#writing = this.#queued.catch(() => {});
    return this.#queued;
  }

  /** Writes unsaved edits synchronously: the page may unload before the database responds. */
  saveDraft() {
    const work = workOf(this.face);
    if (work && JSON.stringify(work) !== this.#stored.work) writeDraft(this.#slot, work);
  }

  async #lock() {
    if (this.#release || !this.#wantsLock) return;
    this.#setRelease((await lockSlot(this.#slot)) ?? (await this.#move()));
  }

  #setRelease(release: (() => void) | undefined) {
    this.#release = release;
    if (!this.#wantsLock) this.unlock();
  }

  /** Switches to a new slot. */
  #move() {
    this.#slot = crypto.randomUUID();
    this.#order = undefined;
    this.#stored = {};
    return lockSlot(this.#slot);
  }

  async #write(): Promise<boolean> {
    await this.#locking;
    const { name, files } = this.face;
    const work = workOf(this.face);
    const text = JSON.stringify(work);
    const isFaceStored = files === this.#stored.files;
    if (!work || (isFaceStored && text === this.#stored.work)) return false;
    try {
      this.#order = await writeSlot(this.#slot, { face: { name, files }, work, isFaceStored, ...(this.#order !== undefined && { since: this.#order }) });
      this.#stored = { files, work: text };
      return !isFaceStored;
    } catch (error) {
      if (!(error instanceof SlotConflict)) throw error;
    }
    // Another tab has written the slot: leave its work there, and save to a new slot.
    this.#release?.();
    this.#setRelease(await this.#move());
    return this.#write();
  }
}

/** The part of a face that changes often; undefined before the face was on the screen. */
function workOf({ photos, pictures, lead, edits, preferences }: Face): Work | undefined {
  return edits === undefined || preferences === undefined ? undefined : { photos, pictures, lead, edits, preferences };
}
