/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 */
import { writeDraft } from "./drafts.js";
import { hold } from "./locks.js";
import { Taken, keep, workIn } from "./slots.js";

/** A face that this tab has opened, and the slot where it is kept. */
export class KeptFace {
  /** @type {OpenedFace} with its photos as they are now */
  face;
  /** @type {Done | undefined} to it when it was last on the screen */
  done;
  #slot;
  /** The order of what the slot held when this tab last kept or read it. @type {number | undefined} */
  #order;
  /** As much as the database has. @type {{ face?: OpenedFace, done?: Done | undefined }} */
  #kept = {};
  #isWanted = false;
  /** @type {(() => void) | undefined} */
  #release;
  /** @type {Promise<void>} */
  #holding = Promise.resolve();
  /** One write after the other: the one in progress, and one that waits. @type {Promise<unknown>} */
  #writing = Promise.resolve();
  /** @type {Promise<boolean> | undefined} */
  #next;

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
   * Reads what was kept, in this visit or another, and holds its slot.
   *
   * @param {string} slot
   * @returns {Promise<{ kept: KeptFace, work: Work } | undefined>} nothing while another tab holds it
   */
  static async reopened(slot) {
    const release = await hold(slot);
    if (!release) return undefined;
    try {
      const { work, order } = await workIn(slot);
      const kept = new KeptFace(work.face, slot);
      kept.#kept = { face: work.face };
      kept.#order = order;
      [kept.#isWanted, kept.#release] = [true, release];
      return { kept, work };
    } catch (error) {
      release();
      throw error;
    }
  }

  /** Holds its slot; a new one, if another tab has it. Whatever is written waits for that. */
  hold() {
    this.#isWanted = true;
    this.#holding = this.#holding.then(() => this.#hold());
  }

  /** Leaves its slot to whichever tab wants it next. */
  letGo() {
    this.#isWanted = false;
    this.#release?.();
    this.#release = undefined;
  }

  /** Has the slot written next time, even if nothing changes. */
  touch() {
    this.#kept.done = undefined;
  }

  /**
   * Keeps what is not kept yet.
   *
   * @returns {Promise<boolean>} whether the face itself was written
   */
  save() {
    this.#next ??= this.#writing.then(() => {
      this.#next = undefined;
      return this.#write();
    });
    this.#writing = this.#next.catch(() => {});
    return this.#next;
  }

  /** A page that is left may not live to see the database's answer. */
  saveDraft() {
    if (this.done && this.done !== this.#kept.done) writeDraft(this.#slot, this.done);
  }

  async #hold() {
    if (this.#release || !this.#isWanted) return;
    this.#keepHold((await hold(this.#slot)) ?? (await this.#move()));
  }

  /** @param {(() => void) | undefined} release */
  #keepHold(release) {
    this.#release = release;
    if (!this.#isWanted) this.letGo();
  }

  /** Goes to a slot of its own. */
  #move() {
    this.#slot = crypto.randomUUID();
    this.#order = undefined;
    this.#kept = {};
    return hold(this.#slot);
  }

  /** @returns {Promise<boolean>} */
  async #write() {
    await this.#holding;
    const { face, done } = this;
    const isFaceKept = face === this.#kept.face;
    if (!done || (isFaceKept && done === this.#kept.done)) return false;
    try {
      this.#order = await keep(this.#slot, { face, done, isFaceKept, ...(this.#order !== undefined && { since: this.#order }) });
      this.#kept = { face, done };
      return !isFaceKept;
    } catch (error) {
      if (!(error instanceof Taken)) throw error;
    }
    // Another tab went on with the slot: its work stays there.
    this.#release?.();
    this.#keepHold(await this.#move());
    return this.#write();
  }
}
