import { lockSlot, readSlot, SlotConflict, writeDraft, writeSlot } from "./slots.ts";
import type { Work } from "./database.ts";
import type { Face } from "./face.ts";
import type { Stored } from "./slots.ts";

/** A face opened in this tab, with its slot in the database. */
export class StoredFace {
  readonly face;
  #slot: string = crypto.randomUUID();
  /** Content of the slot, with the work as JSON; undefined before the first write. */
  #stored: (Stored & { work?: string | undefined }) | undefined;
  /** Resolves to the function that releases the slot. */
  #lock: Promise<() => void> | undefined;
  /** Serialises writes: one in progress, and one queued. */
  #writing: Promise<unknown> = Promise.resolve();
  #queued: Promise<boolean> | undefined;

  constructor(face: Face) {
    this.face = face;
  }

  get slot() {
    return this.#slot;
  }

  /**
   * Locks and reads a slot; throws if it is damaged.
   *
   * @returns undefined if another tab holds the lock
   */
  static async read(slot: string) {
    const release = await lockSlot(slot);
    if (!release) return undefined;
    try {
      const { face, stored } = await readSlot(slot);
      const read = new StoredFace(face);
      [read.#slot, read.#stored, read.#lock] = [slot, stored, Promise.resolve(release)];
      return read;
    } catch (error) {
      release();
      throw error;
    }
  }

  /** Locks the slot, or a new one if another tab holds it. The next save writes the slot even without changes. */
  lock() {
    if (this.#lock) return;
    if (this.#stored) this.#stored.work = undefined;
    this.#lock = this.#acquire();
  }

  /** Releases the lock, for other tabs. */
  unlock() {
    this.#lock?.then((release) => release());
    this.#lock = undefined;
  }

  /**
   * Writes the unsaved changes.
   *
   * @returns whether the face itself was written
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
    if (work && JSON.stringify(work) !== this.#stored?.work) writeDraft(this.#slot, work);
  }

  async #acquire(): Promise<() => void> {
    const release = await lockSlot(this.#slot);
    if (release) return release;
    this.#useNewSlot();
    return this.#acquire();
  }

  #useNewSlot() {
    [this.#slot, this.#stored] = [crypto.randomUUID(), undefined];
  }

  async #write(): Promise<boolean> {
    // A new slot is unknown to other tabs, and its first write must not wait: the page may be left any time.
    if (this.#stored) await this.#lock;
    const { files } = this.face;
    const work = workOf(this.face);
    const text = JSON.stringify(work);
    const hasFace = files === this.#stored?.files;
    if (!work || (hasFace && text === this.#stored?.work)) return false;
    try {
      const order = await writeSlot(this.#slot, this.face, work, this.#stored);
      this.#stored = { order, files, work: text };
      return !hasFace;
    } catch (error) {
      if (!(error instanceof SlotConflict)) throw error;
    }
    // Another tab has written the slot: leave its work there, and save to a new slot.
    const isLocked = this.#lock !== undefined;
    this.unlock();
    this.#useNewSlot();
    if (isLocked) this.lock();
    return this.#write();
  }
}

/** The part of a face that changes often; undefined before the face was on the screen. */
function workOf({ photos, pictures, lead, edits, preferences }: Face): Work | undefined {
  return edits === undefined || preferences === undefined ? undefined : { photos, pictures, lead, edits, preferences };
}
