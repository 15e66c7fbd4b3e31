import { byId } from "../page/dom.js";
import { setKeeping, showError } from "../page/notice.js";
import { standing } from "./standing.js";
import { ownSlot, rememberSlot } from "./own-slot.js";
import { freeSlots, keepDone, keepFace, keepLastWords, lockOf, prune, settle, workIn } from "./slots.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 *
 * @typedef {object} Visited a face that this tab has opened
 * @property {OpenedFace} face
 * @property {string} slot where it is kept; no other tab ever holds it
 * @property {Done} [done] to it when it was last on the screen
 * @property {Done} [stored] as much of it as the database has
 */

/** What is done is kept this long after the last change. */
const PAUSE_MS = 200;

/**
 * Keeps the work in this browser, so that a reload or a crash loses nothing, and offers it on the next visit. Each face that
 * was opened has a slot of its own, which is this tab's for as long as the face is on the screen. What was done to a face is
 * remembered here, too, for as long as anybody has the face: it can be gone back to where the browser keeps nothing.
 */
export class Autosave {
  /** The face on the screen. @type {Visited | undefined} */
  #now;
  /** @type {WeakMap<OpenedFace, Visited>} */
  #visited = new WeakMap();
  /** @type {Workbench | undefined} */
  #bench;
  /** @type {() => void} */
  #letGo = () => {};
  #pause = 0;
  #hasComplained = false;
  /** Whether the studio has lost the work, which is not back yet: what the studio holds is not to be kept, then. */
  #isLost = false;
  /** @type {{ slot: string, face: OpenedFace } | undefined} what was read to be opened again */
  #reopened;
  /** One write after the other. */
  #writing = Promise.resolve();

  constructor() {
    addEventListener("pagehide", () => this.#sayLastWords());
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#sayLastWords();
    });
  }

  /** The face on the screen. */
  get face() {
    return this.#now?.face;
  }

  /**
   * What was done to a face when it was last on the screen in this visit; nothing if it never was.
   *
   * @param {OpenedFace} face
   */
  doneTo(face) {
    return this.#visited.get(face)?.done;
  }

  /**
   * Offers the work of the last visit: this tab's own or, in a new one, the latest that no tab has open.
   *
   * @param {(read: () => Promise<Work>) => void} open
   */
  async offer(open) {
    const slots = await freeSlots().catch(() => []);
    const own = slots.find((slot) => slot === ownSlot());
    const slot = own ?? slots[0];
    if (slot === undefined || this.#now) return;
    const button = byId("continue", HTMLButtonElement);
    button.addEventListener("click", () => open(() => this.#reopen(slot)));
    button.hidden = false;
    // One button is the first choice, and for who returns it is this one.
    for (const other of document.querySelectorAll("#welcome .primary")) other.classList.toggle("primary", other === button);
  }

  /**
   * The work as it was last kept, which the studio has lost.
   *
   * @returns {Work | undefined}
   */
  lose() {
    this.#isLost = true;
    clearTimeout(this.#pause);
    return this.#now?.done && { face: this.#now.face, ...this.#now.done };
  }

  /** @param {Workbench} bench */
  follow(bench) {
    this.#bench = bench;
    bench.onChange(() => {
      if (!this.#now) return;
      clearTimeout(this.#pause);
      this.#pause = setTimeout(() => this.#keepDone(), PAUSE_MS);
    });
  }

  /** Keeps what was done last, before the studio is given another face. */
  finish() {
    this.#keepDone();
  }

  /**
   * Takes charge of a face that has just been opened, in a slot of its own: the one it had if it is gone back to.
   *
   * @param {OpenedFace} face
   */
  take(face) {
    clearTimeout(this.#pause);
    const now = this.#visited.get(face) ?? { face, slot: crypto.randomUUID() };
    const reopenedFrom = face === this.#reopened?.face ? this.#reopened.slot : undefined;
    if (now !== this.#now) this.#hold(now.slot);
    [this.#isLost, this.#reopened, this.#now] = [false, undefined, now];
    this.#visited.set(face, now);
    rememberSlot(now.slot);
    // Not in the task that brings the face to the screen.
    setTimeout(() => this.#write(() => settle(now.slot, face, reopenedFrom)), PAUSE_MS);
    now.done = standing(this.#bench);
    if (now.done) this.#put(now, now.done);
    this.#write(prune);
  }

  /**
   * The face on the screen is seen in other photos from now on: its slot is to hold those.
   *
   * @param {OpenedFace} face
   */
  change(face) {
    if (!this.#now) return;
    const now = { ...this.#now, face };
    this.#now = now;
    this.#visited.set(face, now);
    this.#write(() => keepFace(now.slot, face));
    this.#keepDone();
  }

  /** @param {string} slot */
  async #reopen(slot) {
    try {
      const work = await workIn(slot);
      if (!work) throw new Error("the slot is empty");
      this.#reopened = { slot, face: work.face };
      return work;
    } catch (error) {
      throw { code: "bad-kept-work", message: String(error), hint: "" };
    }
  }

  /**
   * Lets go of the slot before, and waits with all writing until this one is the tab's.
   *
   * @param {string} slot is this tab's until `#letGo`
   */
  #hold(slot) {
    this.#letGo();
    const held = new Promise((/** @type {(value: void) => void} */ resolve) => (this.#letGo = resolve));
    const granted = new Promise((/** @type {(value: void) => void} */ resolve) => {
      // A browser that refuses the lock refuses the database as well, which then says so.
      const holding = navigator.locks.request(lockOf(slot), () => {
        resolve();
        return held;
      });
      holding.catch(() => resolve());
    });
    this.#writing = this.#writing.then(() => granted);
  }

  #keepDone() {
    clearTimeout(this.#pause);
    const now = this.#now;
    const done = this.#isLost ? undefined : now && standing(this.#bench);
    if (!now || !done || JSON.stringify(done) === JSON.stringify(now.done)) return;
    now.done = done;
    this.#put(now, done);
  }

  /**
   * @param {Visited} face
   * @param {Done} done
   */
  #put(face, done) {
    this.#write(async () => {
      await keepDone(face.slot, done);
      face.stored = done;
    });
  }

  /** A page that is left may not live to see the database's answer. */
  #sayLastWords() {
    this.#keepDone();
    const { slot, done, stored } = this.#now ?? {};
    if (slot !== undefined && done && done !== stored) keepLastWords(slot, done);
  }

  /** @param {() => Promise<void>} write */
  #write(write) {
    const written = this.#writing.then(write);
    this.#writing = written.then(() => setKeeping(true), (error) => this.#complain(error));
  }

  /** @param {unknown} error */
  #complain(error) {
    setKeeping(false);
    if (this.#hasComplained) return;
    this.#hasComplained = true;
    showError({ code: "not-kept", message: String(error), hint: "" });
  }
}
