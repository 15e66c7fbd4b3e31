import { byId } from "../page/dom.js";
import { asPageError } from "../page/page-error.js";
import { setKeeping, showError, showRemark } from "../page/notice.js";
import { KeptFace } from "./kept-face.js";
import { ownSlot, rememberSlot } from "./own-slot.js";
import { allSlots, prune } from "./slots.js";
import { standing } from "./standing.js";
import { Late } from "./within.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/host.js").Host} Host
 */

/** What is done is kept this long after the last change. */
const PAUSE_MS = 200;

/**
 * Keeps the work in this browser, so that a reload or a crash loses nothing, and offers it on the next visit. Each face that
 * was opened has a slot of its own, which is this tab's for as long as the face is on the screen. What was done to a face is
 * remembered here, too, for as long as anybody has the face: it can be gone back to where the browser keeps nothing.
 */
export class Autosave {
  /** The face on the screen. @type {KeptFace | undefined} */
  #now;
  /** @type {WeakMap<OpenedFace, KeptFace>} */
  #visited = new WeakMap();
  /** @type {Host | undefined} */
  #host;
  #pause = 0;
  #hasComplained = false;
  /** Whether the studio has lost the work, which is not back yet: what the studio holds is not to be kept, then. */
  #isLost = false;
  /** What was read to be opened again. @type {KeptFace | undefined} */
  #reopened;
  /** What was read, and was not opened. @type {Set<string>} */
  #refused = new Set();

  constructor() {
    addEventListener("pagehide", () => this.#leave());
    addEventListener("pageshow", ({ persisted }) => {
      if (persisted) this.#comeBack();
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#saveDraft();
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
    const [offered] = await this.#freeSlots(ownSlot()).catch(() => []);
    if (offered === undefined || this.#now) return;
    const button = byId("continue", HTMLButtonElement);
    button.addEventListener("click", () => open(() => this.#reopen(offered)));
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

  /** @param {Host} host */
  follow(host) {
    this.#host = host;
    host.onChange(() => {
      if (this.#now) this.#saveSoon();
    });
  }

  /** Keeps what was done last, before the studio is given another face. */
  finish() {
    this.#save();
  }

  /**
   * Takes charge of a face that has just been opened, in a slot of its own: the one it had if it is gone back to.
   *
   * @param {OpenedFace} face
   */
  take(face) {
    const [before, reopened] = [this.#now, this.#reopened];
    const now = this.#visited.get(face) ?? (reopened?.face === face ? reopened : new KeptFace(face));
    for (const other of [before, reopened]) if (other !== now) other?.letGo();
    now.hold();
    [this.#isLost, this.#reopened, this.#now] = [false, undefined, now];
    this.#visited.set(face, now);
    this.#refused.delete(now.slot);
    rememberSlot(now.slot);
    now.done = standing(this.#host);
    // Not in the task that brings the face to the screen.
    this.#saveSoon();
  }

  /**
   * The face on the screen is seen in other photos from now on: its slot is to hold those.
   *
   * @param {OpenedFace} face
   */
  change(face) {
    if (!this.#now) return;
    this.#visited.delete(this.#now.face);
    this.#visited.set(face, this.#now);
    this.#now.face = face;
    this.#save();
  }

  /**
   * The slots that no tab has open, in the order in which they are offered: the first one, the latest, those that were refused.
   *
   * @param {string | null} first
   */
  async #freeSlots(first) {
    const slots = (await allSlots()).filter(({ isWhole, isHeld }) => isWhole && !isHeld).map(({ slot }) => slot);
    const rank = (/** @type {string} */ slot) => (this.#refused.has(slot) ? 2 : slot === first ? 0 : 1);
    return slots.sort((one, other) => rank(one) - rank(other));
  }

  /**
   * The work that was offered or, where another tab has it by now or it cannot be read, the next.
   *
   * @param {string} offered
   * @returns {Promise<Work>}
   */
  async #reopen(offered) {
    this.#reopened?.letGo();
    this.#reopened = undefined;
    try {
      for (const slot of await this.#freeSlots(offered)) {
        const work = await this.#readAgain(slot);
        if (work && slot !== offered) showRemark("earlier-work", {});
        if (work) return work;
      }
      const isElsewhere = (await allSlots()).some(({ slot, isHeld }) => isHeld && slot === offered);
      throw { code: isElsewhere ? "open-elsewhere" : "bad-kept-work", message: `slot ${offered}`, hint: "" };
    } catch (error) {
      throw asPageError(error, "kept-work-busy");
    }
  }

  /**
   * @param {string} slot
   * @returns {Promise<Work | undefined>} nothing where it is another tab's, or damaged
   */
  async #readAgain(slot) {
    try {
      const reopened = await KeptFace.reopened(slot);
      if (!reopened) return undefined;
      this.#refused.add(slot);
      this.#reopened = reopened.kept;
      return reopened.work;
    } catch (error) {
      if (error instanceof Late) throw error;
      console.warn(error);
      return undefined;
    }
  }

  #saveSoon() {
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => this.#save(), PAUSE_MS);
  }

  /** Keeps what is on the screen as it stands. */
  async #save() {
    clearTimeout(this.#pause);
    const now = this.#now;
    const done = this.#isLost ? undefined : now && standing(this.#host);
    if (!now || !done) return;
    if (JSON.stringify(done) !== JSON.stringify(now.done)) now.done = done;
    try {
      const isNew = await now.save();
      if (now === this.#now) rememberSlot(now.slot);
      this.#hasComplained = false;
      setKeeping(true);
      if (isNew) await prune().catch(() => {});
    } catch (error) {
      this.#complain(error);
    }
  }

  #saveDraft() {
    this.#save();
    this.#now?.saveDraft();
  }

  /** The browser may keep a page that is left, and everything in it, for the way back. */
  #leave() {
    this.#saveDraft();
    this.#now?.letGo();
    this.#reopened?.letGo();
  }

  #comeBack() {
    this.#now?.hold();
    this.#now?.touch();
    this.#save();
  }

  /** @param {unknown} error */
  #complain(error) {
    setKeeping(false);
    if (this.#hasComplained) return;
    this.#hasComplained = true;
    showError({ code: "not-kept", message: String(error), hint: "" });
  }
}
