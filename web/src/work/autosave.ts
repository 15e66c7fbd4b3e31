import { byId } from "../page/dom.ts";
import { asPageError } from "../page/page-error.ts";
import { afterNextFrame } from "../page/tasks.ts";
import { setSavesWork, showError, showRemark } from "../page/notice.ts";
import { allSlots, prune } from "./slots.ts";
import { StoredFace } from "./stored-face.ts";
import { rememberTabSlot, tabSlot } from "./tab-slot.ts";
import { TimeoutError } from "./timeout.ts";
import type { Face } from "./face.ts";
import type { Host } from "../viewport/host.ts";

/** Debounce delay after the last change. */
const SAVE_DELAY_MS = 200;

/**
 * Saves the work in this browser, so that it survives a reload or a crash, and offers it on the next visit. Each opened
 * face has one slot, locked by this tab while the face is on the screen.
 */
export class Autosave {
  /** The face on the screen. */
  #now: StoredFace | undefined;
  #visited: WeakMap<Face, StoredFace> = new WeakMap();
  #remember;
  #timer = 0;
  #hasReported = false;
  /** Read from the database, about to be opened. */
  #reopened: StoredFace | undefined;
  /** Slots that were read but could not be opened. */
  #rejected: Set<string> = new Set();

  /** @param remember updates the face on the screen with its current edits */
  constructor(remember: () => void) {
    this.#remember = remember;
    addEventListener("pagehide", () => this.#onPageHide());
    addEventListener("pageshow", ({ persisted }) => {
      if (persisted) this.#onPageRestored();
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#saveDraft();
    });
  }

  /** Offers the work of the last visit: this tab's before a reload, or the latest that no tab has open. */
  async offer(open: (read: () => Promise<Face>) => void) {
    const [offered] = await this.#freeSlots(tabSlot()).catch(() => []);
    if (offered === undefined || this.#now) return;
    const button = byId("continue", HTMLButtonElement);
    button.addEventListener("click", () => open(() => this.#reopen(offered)));
    button.hidden = false;
    // Make this the only primary button.
    for (const other of document.querySelectorAll("#welcome .primary")) other.classList.toggle("primary", other === button);
  }

  /** Saves after each change from now on. */
  follow(host: Host) {
    host.on("change", () => {
      if (this.#now) this.#saveSoon();
    });
  }

  /** Saves pending changes now. */
  flush() {
    this.#save();
  }

  /** Starts saving a face that was just opened, to its earlier slot if it has one. */
  start(face: Face) {
    const [before, reopened] = [this.#now, this.#reopened];
    const now = this.#visited.get(face) ?? (reopened?.face === face ? reopened : new StoredFace(face));
    for (const other of [before, reopened]) if (other !== now) other?.unlock();
    now.lock();
    [this.#reopened, this.#now] = [undefined, now];
    this.#visited.set(face, now);
    this.#rejected.delete(now.slot);
    rememberTabSlot(now.slot);
    // The current task brings the face to the screen. Whoever leaves right after keeps it.
    afterNextFrame().then(() => this.#save());
  }

  /** The slots that no tab has open: the preferred one, then the latest, then those rejected before. */
  async #freeSlots(preferred: string | null) {
    const slots = (await allSlots()).filter(({ isComplete, isLocked }) => isComplete && !isLocked).map(({ slot }) => slot);
    const rank = (slot: string) => (this.#rejected.has(slot) ? 2 : slot === preferred ? 0 : 1);
    return slots.sort((a, b) => rank(a) - rank(b));
  }

  /** Reads the offered work. If another tab has opened it or it is corrupt, reads the next. */
  async #reopen(offered: string): Promise<Face> {
    this.#reopened?.unlock();
    this.#reopened = undefined;
    try {
      for (const slot of await this.#freeSlots(offered)) {
        const face = await this.#readSlot(slot);
        if (face && slot !== offered) showRemark("earlier-work", {});
        if (face) return face;
      }
      const isElsewhere = (await allSlots()).some(({ slot, isLocked }) => isLocked && slot === offered);
      throw { code: isElsewhere ? "open-elsewhere" : "bad-kept-work", message: `slot ${offered}`, hint: "" };
    } catch (error) {
      throw asPageError(error, "kept-work-busy");
    }
  }

  /** @returns undefined if another tab holds the slot, or it is corrupt */
  async #readSlot(slot: string): Promise<Face | undefined> {
    try {
      const stored = await StoredFace.read(slot);
      if (!stored) return undefined;
      // Removed again once the face is open.
      this.#rejected.add(slot);
      this.#reopened = stored;
      return stored.face;
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
    if (!now) return;
    this.#remember();
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

  /** Shows an error once per series of failed saves. */
  #report(error: unknown) {
    setSavesWork(false);
    if (this.#hasReported) return;
    this.#hasReported = true;
    showError({ code: "not-kept", message: String(error), hint: "" });
  }
}
