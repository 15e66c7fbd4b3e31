import { byId } from "../page/dom.ts";
import { setSavesWork, showError, showRemark } from "../page/notice.ts";
import { asPageError } from "../page/page-error.ts";
import { attempt, TimeoutError } from "./database.ts";
import { isSlotLocked, listSlots, prune } from "./slots.ts";
import { StoredFace } from "./stored-face.ts";
import type { Host } from "../viewport/host.ts";
import type { Face } from "./face.ts";

/** Debounce delay after an edit. While a page is left, edits are saved as a draft. */
const SAVE_DELAY_MS = 200;

/** Longest wait, after a reload, for the end of the lock of the page before. */
const LEAVING_MS = 1000;
const POLL_MS = 50;

/** Key in session storage, which survives a reload, of the slot that this tab has open. */
const TAB_SLOT = "rosto.slot";

/**
 * Saves the work in this browser, so that it survives a reload or a crash, and offers it on the next visit. Each opened
 * face has one slot, locked by this tab while the face is on the screen.
 */
export class Autosave {
  /** The face on the screen. */
  #now: StoredFace | undefined;
  /** Read from the database, to be opened. */
  #read: StoredFace | undefined;
  #visited = new WeakMap<Face, StoredFace>();
  /** Slots that were read but could not be opened. */
  #rejected = new Set<string>();
  #remember;
  #timer = 0;
  #hasReported = false;

  /** @param remember updates the face on the screen with its current edits */
  constructor(remember: () => void) {
    this.#remember = remember;
    addEventListener("pagehide", () => {
      this.#leave();
      // The page may enter the back/forward cache.
      this.#now?.unlock();
    });
    addEventListener("pageshow", ({ persisted }) => {
      if (!persisted) return;
      this.#now?.lock();
      this.save();
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#leave();
    });
  }

  /** Offers the work of the last visit: this tab's before a reload, or the latest that no tab has open. */
  async offer(open: (read: () => Promise<Face>) => Promise<void>) {
    const preferred = attempt(() => sessionStorage.getItem(TAB_SLOT)) ?? "";
    await untilLeft(preferred);
    const [offered] = await this.#freeSlots(preferred).catch(() => []);
    if (offered === undefined || this.#now) return;
    const button = byId("continue", HTMLButtonElement);
    button.addEventListener("click", async () => {
      await open(() => this.#reopen(offered));
      const read = this.#read;
      if (!read || read === this.#now) return;
      read.unlock();
      this.#rejected.add(read.slot);
    });
    button.hidden = false;
    // Make this the only primary button.
    const primary = document.querySelectorAll("#welcome .primary");
    for (const other of primary) other.classList.toggle("primary", other === button);
  }

  /** Saves after each change from now on. */
  follow(host: Host) {
    host.on("change", () => {
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.save(), SAVE_DELAY_MS);
    });
  }

  /** Saves a face that was just opened, to its earlier slot if it has one, and from now on its changes. */
  start(face: Face) {
    const before = this.#now;
    const now = this.#visited.get(face) ?? new StoredFace(face);
    this.#visited.set(face, now);
    this.#now = now;
    now.lock();
    this.#rejected.delete(now.slot);
    if (before && before !== now) this.#write(before).then(() => before !== this.#now && before.unlock());
    // At once: the user may leave as soon as the face is shown.
    this.save();
  }

  /** Saves pending changes now. */
  save() {
    clearTimeout(this.#timer);
    const now = this.#now;
    if (!now) return;
    this.#remember();
    // If storage is blocked, the next visit offers the latest work instead.
    attempt(() => sessionStorage.setItem(TAB_SLOT, now.slot));
    this.#write(now);
  }

  #leave() {
    this.save();
    this.#now?.saveDraft();
  }

  /** The slots that no tab has open: the preferred one, then the latest, then those rejected before. */
  async #freeSlots(preferred: string) {
    const slots = (await listSlots()).filter(({ isLocked }) => !isLocked);
    const rank = (slot: string) => (this.#rejected.has(slot) ? 2 : slot === preferred ? 0 : 1);
    return slots.map(({ slot }) => slot).sort((one, other) => rank(one) - rank(other));
  }

  /** Reads the offered work. If another tab has opened it or it is damaged, reads the next. */
  async #reopen(offered: string) {
    try {
      for (const slot of await this.#freeSlots(offered)) {
        const read = await StoredFace.read(slot).catch(ignoreDamage);
        if (!read) continue;
        if (slot !== offered) showRemark("earlier-work", {});
        this.#read = read;
        this.#visited.set(read.face, read);
        return read.face;
      }
      const isElsewhere = (await listSlots()).some(({ slot, isLocked }) => isLocked && slot === offered);
      throw { code: isElsewhere ? "open-elsewhere" : "bad-kept-work", message: `slot ${offered}`, hint: "" };
    } catch (error) {
      throw asPageError(error, "kept-work-busy");
    }
  }

  async #write(stored: StoredFace) {
    try {
      const isNew = await stored.save();
      this.#hasReported = false;
      setSavesWork(true);
      if (isNew) await prune().catch(() => {});
    } catch (error) {
      setSavesWork(false);
      // Once per series of failed saves.
      if (!this.#hasReported) showError({ code: "not-kept", message: String(error), hint: "" });
      this.#hasReported = true;
    }
  }
}

/** Waits until the slot is free: a busy browser may still hold it for the page before a reload. */
async function untilLeft(slot: string) {
  const start_ms = performance.now();
  while (slot !== "" && performance.now() - start_ms < LEAVING_MS && (await isSlotLocked(slot))) {
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
}

function ignoreDamage(error: unknown) {
  if (error instanceof TimeoutError) throw error;
  console.warn(error);
  return undefined;
}
