import { byId } from "../page/dom.js";
import { setKeeping, showError } from "../page/notice.js";
import { dropIfFree, freeSlots, keepDone, keepFace, keepLastWords, lockOf, prune, workIn } from "./slots.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 */

/** What is done is kept this long after the last change. */
const PAUSE_MS = 200;

/** This tab's slot outlives a reload. */
const SLOT = "rosto.slot";

/**
 * Keeps the work in this browser, so that a reload or a crash loses nothing, and offers it on the next visit. The face on
 * the screen has a slot of its own, which is this tab's for as long as the face is open.
 */
export class Autosave {
  /** @type {OpenedFace | undefined} */
  #face;
  /** @type {Done | undefined} */
  #done;
  /** As much of it as the database has. @type {Done | undefined} */
  #stored;
  /** @type {Workbench | undefined} */
  #bench;
  #slot = "";
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
    return this.#face;
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
    if (slot === undefined || this.#face) return;
    const button = byId("continue", HTMLButtonElement);
    button.hidden = false;
    button.addEventListener("click", () => open(() => this.#reopen(slot)));
  }

  /**
   * The work as it was last kept, which the studio has lost.
   *
   * @returns {Work | undefined}
   */
  lose() {
    this.#isLost = true;
    clearTimeout(this.#pause);
    return this.#face && this.#done && { face: this.#face, ...this.#done };
  }

  /** @param {Workbench} bench */
  follow(bench) {
    this.#bench = bench;
    bench.onChange(() => {
      if (!this.#face) return;
      clearTimeout(this.#pause);
      this.#pause = setTimeout(() => this.#keepDone(), PAUSE_MS);
    });
  }

  /** Keeps what was done last, before the studio is given another face. */
  finish() {
    this.#keepDone();
  }

  /**
   * Takes charge of a face that has just been opened, in a slot of its own.
   *
   * @param {OpenedFace} face
   */
  take(face) {
    clearTimeout(this.#pause);
    this.#letGo();
    const slot = crypto.randomUUID();
    // The same face again, whose work was lost or kept.
    const before = face === this.#face ? this.#slot : face === this.#reopened?.face ? this.#reopened.slot : undefined;
    [this.#isLost, this.#reopened] = [false, undefined];
    [this.#slot, this.#face, this.#done] = [slot, face, this.#standing()];
    rememberSlot(slot);
    this.#hold(slot);
    // Not in the task that brings the face to the screen.
    setTimeout(() => this.#write(() => move(slot, face, before)), PAUSE_MS);
    if (this.#done) this.#put(slot, this.#done);
    this.#write(prune);
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

  /** @param {string} slot is this tab's until `#letGo` */
  #hold(slot) {
    const held = new Promise((/** @type {(value: void) => void} */ resolve) => (this.#letGo = resolve));
    navigator.locks.request(lockOf(slot), () => held);
  }

  /** @returns {Done | undefined} what was done to the face as it stands */
  #standing() {
    return this.#bench?.read((state, studio) => {
      const [triangulation = "", density = "0"] = ["triangulation", "density"].map((choice) => state.chosen(choice));
      return { edits: studio.editsJson(), triangulation, density: Number(density), preferences: studio.preferences() };
    });
  }

  #keepDone() {
    clearTimeout(this.#pause);
    const slot = this.#slot;
    const done = this.#face && !this.#isLost && this.#standing();
    if (!done || JSON.stringify(done) === JSON.stringify(this.#done)) return;
    this.#done = done;
    this.#put(slot, done);
  }

  /**
   * @param {string} slot
   * @param {Done} done
   */
  #put(slot, done) {
    this.#write(async () => {
      await keepDone(slot, done);
      this.#stored = done;
    });
  }

  /** A page that is left may not live to see the database's answer. */
  #sayLastWords() {
    this.#keepDone();
    if (this.#done && this.#done !== this.#stored) keepLastWords(this.#slot, this.#done);
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

/**
 * Keeps a face in its slot, after which the one that it was in before is of no more use.
 *
 * @param {string} slot
 * @param {OpenedFace} face
 * @param {string} [before]
 */
async function move(slot, face, before) {
  await keepFace(slot, face);
  if (before !== undefined) await dropIfFree(before);
}

function ownSlot() {
  try {
    return sessionStorage.getItem(SLOT);
  } catch {
    return null;
  }
}

/** @param {string} slot */
function rememberSlot(slot) {
  try {
    sessionStorage.setItem(SLOT, slot);
  } catch {
    // The next visit then offers the latest work.
  }
}
