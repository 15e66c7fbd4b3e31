import { byId } from "../page/dom.js";
import { asPageError } from "../page/page-error.js";
import { setSavesWork, showError, showRemark } from "../page/notice.js";
import { editStateOf } from "./edit-state.js";
import { allSlots, prune } from "./slots.js";
import { StoredFace } from "./stored-face.js";
import { rememberTabSlot, tabSlot } from "./tab-slot.js";
import { TimeoutError } from "./timeout.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("../viewport/host.js").Host} Host
 */

/** Debounce delay after the last change. */
const SAVE_DELAY_MS = 200;

/**
 * Saves the work in this browser, so that it survives a reload or a crash, and offers it on the next visit. Each opened
 * face has one slot, locked by this tab while the face is on the screen. The edits of earlier faces also stay in
 * memory, so that the user can return to them without storage.
 */
export class Autosave {
  /** The face on the screen. @type {StoredFace | undefined} */
  #now;
  /** @type {WeakMap<OpenedFace, StoredFace>} */
  #visited = new WeakMap();
  /** @type {Host | undefined} */
  #host;
  #timer = 0;
  #hasReported = false;
  /** Set after a crash until the work is restored: the studio's state must not be saved meanwhile. */
  #isSuspended = false;
  /** Read from the database, about to be opened. @type {StoredFace | undefined} */
  #reopened;
  /** Slots that were read but could not be opened. @type {Set<string>} */
  #rejected = new Set();

  constructor() {
    addEventListener("pagehide", () => this.#onPageHide());
    addEventListener("pageshow", ({ persisted }) => {
      if (persisted) this.#onPageRestored();
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
   * The edits of a face opened earlier in this visit.
   *
   * @param {OpenedFace} face
   */
  lastEditsOf(face) {
    return this.#visited.get(face)?.edits;
  }

  /**
   * Offers the work of the last visit: this tab's before a reload, or the latest that no tab has open.
   *
   * @param {(read: () => Promise<Work>) => void} open
   */
  async offer(open) {
    const [offered] = await this.#freeSlots(tabSlot()).catch(() => []);
    if (offered === undefined || this.#now) return;
    const button = byId("continue", HTMLButtonElement);
    button.addEventListener("click", () => open(() => this.#reopen(offered)));
    button.hidden = false;
    // Make this the only primary button.
    for (const other of document.querySelectorAll("#welcome .primary")) other.classList.toggle("primary", other === button);
  }

  /**
   * Suspends saving after the studio has crashed.
   *
   * @returns {Work | undefined} the last saved work, to be restored
   */
  suspend() {
    this.#isSuspended = true;
    clearTimeout(this.#timer);
    return this.#now?.edits && { face: this.#now.face, ...this.#now.edits };
  }

  /** Saves after each change from now on. @param {Host} host */
  follow(host) {
    this.#host = host;
    host.onChange(() => {
      if (this.#now) this.#saveSoon();
    });
  }

  /** Saves pending changes, before another face is opened. */
  flush() {
    this.#save();
  }

  /**
   * Starts saving a face that was just opened, to its earlier slot if it has one.
   *
   * @param {OpenedFace} face
   */
  start(face) {
    const [before, reopened] = [this.#now, this.#reopened];
    const now = this.#visited.get(face) ?? (reopened?.face === face ? reopened : new StoredFace(face));
    for (const other of [before, reopened]) if (other !== now) other?.unlock();
    now.lock();
    [this.#isSuspended, this.#reopened, this.#now] = [false, undefined, now];
    this.#visited.set(face, now);
    this.#rejected.delete(now.slot);
    rememberTabSlot(now.slot);
    now.edits = editStateOf(this.#host);
    // Deferred: the current task brings the face to the screen.
    this.#saveSoon();
  }

  /**
   * Replaces the current face after its photos have changed. The slot stays the same.
   *
   * @param {OpenedFace} face
   */
  replaceFace(face) {
    if (!this.#now) return;
    this.#visited.delete(this.#now.face);
    this.#visited.set(face, this.#now);
    this.#now.face = face;
    this.#save();
  }

  /**
   * The slots that no tab has open: the preferred one, then the latest, then those rejected before.
   *
   * @param {string | null} preferred
   */
  async #freeSlots(preferred) {
    const slots = (await allSlots()).filter(({ isComplete, isLocked }) => isComplete && !isLocked).map(({ slot }) => slot);
    const rank = (/** @type {string} */ slot) => (this.#rejected.has(slot) ? 2 : slot === preferred ? 0 : 1);
    return slots.sort((a, b) => rank(a) - rank(b));
  }

  /**
   * Reads the offered work. If another tab has opened it or it is corrupt, reads the next.
   *
   * @param {string} offered
   * @returns {Promise<Work>}
   */
  async #reopen(offered) {
    this.#reopened?.unlock();
    this.#reopened = undefined;
    try {
      for (const slot of await this.#freeSlots(offered)) {
        const work = await this.#readSlot(slot);
        if (work && slot !== offered) showRemark("earlier-work", {});
        if (work) return work;
      }
      const isElsewhere = (await allSlots()).some(({ slot, isLocked }) => isLocked && slot === offered);
      throw { code: isElsewhere ? "open-elsewhere" : "bad-kept-work", message: `slot ${offered}`, hint: "" };
    } catch (error) {
      throw asPageError(error, "kept-work-busy");
    }
  }

  /**
   * @param {string} slot
   * @returns {Promise<Work | undefined>} undefined if another tab holds the slot, or it is corrupt
   */
  async #readSlot(slot) {
    try {
      const read = await StoredFace.read(slot);
      if (!read) return undefined;
      // Removed again once the face is open.
      this.#rejected.add(slot);
      this.#reopened = read.stored;
      return read.work;
    } catch (error) {
      if (error instanceof TimeoutError) throw error;
      console.warn(error);
      return undefined;
    }
  }

  #saveSoon() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#save(), SAVE_DELAY_MS);
  }

  async #save() {
    clearTimeout(this.#timer);
    const now = this.#now;
    const edits = this.#isSuspended ? undefined : now && editStateOf(this.#host);
    if (!now || !edits) return;
    // StoredFace detects changes by identity.
    if (JSON.stringify(edits) !== JSON.stringify(now.edits)) now.edits = edits;
    try {
      const isNew = await now.save();
      if (now === this.#now) rememberTabSlot(now.slot);
      this.#hasReported = false;
      setSavesWork(true);
      if (isNew) await prune().catch(() => {});
    } catch (error) {
      this.#report(error);
    }
  }

  #saveDraft() {
    this.#save();
    this.#now?.saveDraft();
  }

  /** The page may enter the back/forward cache, so the locks are released. */
  #onPageHide() {
    this.#saveDraft();
    this.#now?.unlock();
    this.#reopened?.unlock();
  }

  #onPageRestored() {
    this.#now?.lock();
    this.#now?.markDirty();
    this.#save();
  }

  /** Shows an error once per series of failed saves. @param {unknown} error */
  #report(error) {
    setSavesWork(false);
    if (this.#hasReported) return;
    this.#hasReported = true;
    showError({ code: "not-kept", message: String(error), hint: "" });
  }
}
