/**
 * @typedef {import("./face.js").Face} Face
 * @typedef {import("./row-checks.js").Work} Work
 */
import { writeDraft } from "./drafts.js";
import { lockSlot } from "./locks.js";
import { SlotConflict, readSlot, writeSlot } from "./slots.js";

/** A face opened in this tab, with its slot in the database. */
export class StoredFace {
  #slot;
  /** Save order of the slot when this tab last wrote or read it. @type {number | undefined} */
  #order;
  /** The part that is already in the database; the work as JSON. @type {{ files?: Face["files"], work?: string | undefined }} */
  #stored = {};
  #wantsLock = false;
  /** @type {(() => void) | undefined} */
  #release;
  /** @type {Promise<void>} */
  #locking = Promise.resolve();
  /** Serialises writes: one in progress, and one queued. @type {Promise<unknown>} */
  #writing = Promise.resolve();
  /** @type {Promise<boolean> | undefined} */
  #queued;

  /**
   * @param {Face} face
   * @param {string} [slot]
   */
  constructor(face, slot = crypto.randomUUID()) {
    this.face = face;
    this.#slot = slot;
  }

  get slot() {
    return this.#slot;
  }

  /**
   * Locks and reads a slot.
   *
   * @param {string} slot
   * @returns {Promise<StoredFace | undefined>} undefined if another tab holds the lock
   */
  static async read(slot) {
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
   * @returns {Promise<boolean>} whether the face itself was written
   */
  save() {
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

  /** @param {(() => void) | undefined} release */
  #setRelease(release) {
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

  /** @returns {Promise<boolean>} */
  async #write() {
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

/**
 * The part of a face that changes often; undefined before the face was on the screen.
 *
 * @param {Face} face
 * @returns {Work | undefined}
 */
function workOf({ photos, pictures, lead, edits, preferences }) {
  return edits === undefined || preferences === undefined ? undefined : { photos, pictures, lead, edits, preferences };
}
