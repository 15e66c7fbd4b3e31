/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").EditState} EditState
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 */
import { writeDraft } from "./drafts.js";
import { lockSlot } from "./locks.js";
import { SlotConflict, readSlot, writeSlot } from "./slots.js";

/** A face opened in this tab, with its slot in the database. */
export class StoredFace {
  /** @type {OpenedFace} with its current photos */
  face;
  /** @type {EditState | undefined} when the face was last on the screen */
  edits;
  #slot;
  /** Save order of the slot when this tab last wrote or read it. @type {number | undefined} */
  #order;
  /** The part that is already in the database. @type {{ face?: OpenedFace, edits?: EditState | undefined }} */
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
   * @param {OpenedFace} face
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
   * @returns {Promise<{ stored: StoredFace, work: Work } | undefined>} undefined if another tab holds the lock
   */
  static async read(slot) {
    const release = await lockSlot(slot);
    if (!release) return undefined;
    try {
      const { work, order } = await readSlot(slot);
      const stored = new StoredFace(work.face, slot);
      stored.#stored = { face: work.face };
      stored.#order = order;
      [stored.#wantsLock, stored.#release] = [true, release];
      return { stored, work };
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
    this.#stored.edits = undefined;
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
    if (this.edits && this.edits !== this.#stored.edits) writeDraft(this.#slot, this.edits);
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
    const { face, edits } = this;
    const isFaceStored = face === this.#stored.face;
    if (!edits || (isFaceStored && edits === this.#stored.edits)) return false;
    try {
      this.#order = await writeSlot(this.#slot, { face, edits, isFaceStored, ...(this.#order !== undefined && { since: this.#order }) });
      this.#stored = { face, edits };
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
