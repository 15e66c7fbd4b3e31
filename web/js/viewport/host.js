import { asPageError } from "../page/page-error.js";
import { afterNextFrame, nextTask } from "../page/tasks.js";
import { DeviceLossHandler } from "./device-loss.js";
import { disown, isTrap, noteTrap, openStudio, restarting, restartStudio } from "./studio-module.js";
import { watchWebGl } from "./webgl-errors.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioState} StudioState
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioTick} StudioTick
 * @typedef {import("../../wasm/rosto-studio-web.js").ChangeName} ChangeName
 *
 * @typedef {object} Notices where it is said what went wrong
 * @property {(thrown: unknown, owner: "studio" | "gpu") => void} show
 * @property {(owner: "studio" | "gpu") => void} hide takes away what that owner has shown, and nothing else
 *
 * @typedef {object} Picture straight RGBA
 * @property {Uint8Array} picture
 * @property {number} pictureWidth_px
 * @property {number} pictureHeight_px
 */

/**
 * @template T
 * @typedef {object} Lease something of the module's that outlives a task
 * @property {<A>(question: (object: T) => A) => A} ask throws once the module has trapped
 * @property {() => void} end
 */

/** A module that trapped so many times within a minute is not started again. */
const MOST_RESTARTS = 3;
const RESTARTS_WITHIN_MS = 60_000;

/**
 * Holds the studio, which holds the user's work, and tells the page when anything about it has changed. It draws
 * only in an animation frame, and asks for one only when there is something new to see. A studio whose module traps is
 * replaced by a new one. Nobody else has the studio: `act`, `ask` and `answer` lend it for the length of a call, and only
 * while its module is sound.
 */
export class Host {
  #frameIsComing = false;
  #isBroken = false;
  #studio;
  /** Another one from the moment on that the module traps. */
  #life = {};
  /** @type {number[]} when the module was started again, in ms */
  #restarts = [];
  #gpu;
  /** @type {Set<(state: StudioState) => void>} */
  #changeListeners = new Set();
  /** @type {Set<(tick: StudioTick) => void>} */
  #tickListeners = new Set();
  /** @type {Set<() => void>} */
  #frameListeners = new Set();
  /** @type {Set<() => void>} */
  #photoListeners = new Set();
  #photoIsComing = false;
  #gone = new AbortController();
  #notices;
  /** @type {Set<() => Promise<void>>} */
  #restartListeners = new Set();

  /**
   * Opens a studio on the canvas; throws `{code: "no-webgl", …}` where the browser cannot draw in 3D.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Notices} notices
   */
  static async open(canvas, notices) {
    return new Host(canvas, await openStudio(canvas), notices);
  }

  /** All that are open: they share the module, and its fate. @type {Set<Host>} */
  static #open = new Set();
  /** Traps that were seen to: some are reported by several. @type {WeakSet<Error>} */
  static #seen = new WeakSet();

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Studio} studio
   * @param {Notices} notices
   */
  constructor(canvas, studio, notices) {
    this.canvas = canvas;
    this.#studio = studio;
    this.#notices = notices;
    this.#gpu = new DeviceLossHandler(this, notices);
    this.#followSize();
    Host.#open.add(this);
  }

  /** Aborted when the host is closed. */
  get gone() {
    return this.#gone.signal;
  }

  /** The same object for as long as the studio is the same one. */
  get life() {
    return this.#life;
  }

  /** Gives the studio's memory and its GPU back; the canvas is of no further use. */
  close() {
    if (this.gone.aborted) return;
    const isFree = !this.#isBroken;
    this.#isBroken = true;
    this.#gone.abort();
    Host.#open.delete(this);
    if (isFree) this.#studio.free();
    this.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /**
   * Carries an intent out and tells who shows what it has changed; what goes wrong is shown.
   *
   * @param {(studio: Studio) => ChangeName | void} intent
   */
  act(intent) {
    if (this.#isBroken) return;
    try {
      this.attempt(intent);
    } catch (error) {
      this.fail(error);
    }
  }

  /**
   * The same, but what goes wrong is thrown.
   *
   * @param {(studio: Studio) => ChangeName | void} intent
   */
  attempt(intent) {
    const changed = this.answer(intent);
    if (changed !== "nothing") this.requestFrame();
    if (changed === "document") this.announce();
    if (changed === "tick") this.#tellTick();
    if (changed === "document" || changed === "tick") this.tellPhoto();
  }

  /**
   * What the studio answers; nothing while it cannot.
   *
   * @template T
   * @param {(studio: Studio) => T} question
   * @returns {T | undefined}
   */
  ask(question) {
    if (this.#isBroken) return undefined;
    try {
      return this.answer(question);
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /**
   * What the studio answers; `{code: "restarting", …}` is thrown while it cannot, and so is what goes wrong.
   *
   * @template T
   * @param {(studio: Studio) => T} question
   * @returns {T}
   */
  answer(question) {
    if (this.#isBroken) throw restarting();
    try {
      return question(this.#studio);
    } catch (error) {
      // At once: whoever is next must not get into the module any more.
      if (isTrap(error)) this.fail(error);
      throw error;
    }
  }

  /**
   * Has the studio draw a picture, and takes its pixels.
   *
   * @param {(studio: Studio) => ReturnType<Studio["snapshot"]>} look
   * @returns {Promise<Picture>}
   */
  async picture(look) {
    const life = this.#life;
    const check = watchWebGl(this.canvas);
    const snapshot = await this.answer(look);
    if (life !== this.#life) {
      disown(snapshot);
      throw restarting();
    }
    return this.answer(() => {
      const size = { pictureWidth_px: snapshot.width, pictureHeight_px: snapshot.height };
      const picture = snapshot.takePixels();
      snapshot.free();
      check();
      return { picture, ...size };
    });
  }

  /**
   * Something that the studio makes and that is asked more than once.
   *
   * @template {{ free: () => void }} T
   * @param {(studio: Studio) => T} make
   * @returns {Lease<T>}
   */
  lease(make) {
    const [object, life] = [this.answer(make), this.#life];
    return {
      ask: (question) => {
        if (life !== this.#life) throw restarting();
        return this.answer(() => question(object));
      },
      end: () => (life === this.#life ? object.free() : disown(object)),
    };
  }

  /**
   * What is taken out of the state; nothing while there is none.
   *
   * @template T
   * @param {(state: StudioState, studio: Studio) => T} take
   * @returns {T | undefined}
   */
  read(take) {
    return this.ask((studio) => {
      const state = studio.state();
      const taken = take(state, studio);
      this.#giveBack(state);
      return taken;
    });
  }

  /**
   * Shows what went wrong with the studio; one whose module trapped is replaced.
   *
   * @param {unknown} error
   */
  fail(error) {
    if (!isTrap(error)) {
      const isLate = asPageError(error).code === "restarting";
      if (isLate === this.#isBroken) this.#notices.show(error, "studio");
    } else if (!Host.#seen.has(error)) {
      Host.#seen.add(error);
      noteTrap();
      for (const host of Host.#open) host.#restart(error);
    }
  }

  /**
   * What a listener was given may have been asked when the module trapped.
   *
   * @param {{ free: () => void }} object
   */
  #giveBack(object) {
    if (this.#isBroken) disown(object);
    else object.free();
  }

  /** @param {(state: StudioState) => void} listener is told whenever the document or a choice has changed */
  onChange(listener) {
    this.#changeListeners.add(listener);
  }

  /** @param {(tick: StudioTick) => void} listener is told that as well, and each tick of an edit in progress */
  onTick(listener) {
    this.#tickListeners.add(listener);
  }

  /** @param {() => void} listener runs after each frame drawn */
  onFrame(listener) {
    this.#frameListeners.add(listener);
  }

  /** @param {() => void} listener runs when the photo has followed the edits, once a frame at most */
  onPhoto(listener) {
    this.#photoListeners.add(listener);
  }

  /** @param {() => Promise<void>} listener brings the work back after the studio was replaced by an empty one */
  onRestart(listener) {
    this.#restartListeners.add(listener);
  }

  /** Tells every listener how things stand. */
  announce() {
    this.read((state) => {
      for (const listener of this.#changeListeners) this.ask(() => listener(state));
    });
    this.#tellTick();
  }

  /** Shows the photo as it follows the edits: what asks for a factorisation, and who draws it elsewhere, in tasks of their own. */
  async tellPhoto() {
    if (this.#photoIsComing) return;
    this.#photoIsComing = true;
    await afterNextFrame();
    this.#photoIsComing = false;
    if (this.ask((studio) => studio.photoIsDue)) this.act((studio) => studio.followPhoto());
    this.requestFrame();
    await nextTask();
    for (const listener of this.#photoListeners) this.ask(() => listener());
  }

  /** Draws in the next animation frame. */
  requestFrame() {
    if (this.#frameIsComing) return;
    this.#frameIsComing = true;
    requestAnimationFrame((time_ms) => {
      this.#frameIsComing = false;
      this.#draw(time_ms);
    });
  }

  #tellTick() {
    const tick = this.ask((studio) => studio.tick());
    if (!tick) return;
    for (const listener of this.#tickListeners) this.ask(() => listener(tick));
    this.#giveBack(tick);
  }

  /** @param {number} time_ms */
  #draw(time_ms) {
    if (!this.#gpu.isThere || this.#isBroken) return;
    try {
      const wantsMore = this.answer((studio) => studio.draw(time_ms));
      for (const listener of this.#frameListeners) listener();
      if (wantsMore) this.requestFrame();
    } catch (error) {
      if (asPageError(error).code !== "device-lost") this.fail(error);
    }
  }

  /**
   * After a trap the module's memory is in an unknown state, and none of its methods may be called again.
   *
   * @param {Error} trap
   */
  async #restart(trap) {
    if (this.#isBroken) return;
    this.#isBroken = true;
    this.#life = {};
    disown(this.#studio);
    console.warn("the module is started again:", trap);
    const now_ms = performance.now();
    this.#restarts = [...this.#restarts.filter((at_ms) => now_ms - at_ms < RESTARTS_WITHIN_MS), now_ms];
    try {
      if (this.#restarts.length > MOST_RESTARTS) throw { code: "internal", message: trap.message, hint: "" };
      const studio = await restartStudio(this.canvas);
      if (this.gone.aborted) return studio.free();
      this.#studio = studio;
      this.#isBroken = false;
      this.#gpu.watch();
      this.#fitSize?.();
      for (const listener of this.#restartListeners) await listener();
      this.announce();
      this.tellPhoto();
      this.#notices.hide("gpu");
      this.#notices.show({ code: "restarted", message: trap.message, hint: "" }, "studio");
    } catch (error) {
      this.#notices.show(error, "studio");
    }
  }

  /** @type {(() => void) | undefined} */
  #fitSize;

  #followSize() {
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const size = deviceSize(entry);
      this.#fitSize = () => this.act((studio) => studio.resize(size.width_px, size.height_px, devicePixelRatio));
      this.#fitSize();
    });
    observer.observe(this.canvas);
    this.gone.addEventListener("abort", () => observer.disconnect());
  }
}

/**
 * The canvas's size in device pixels, exact where the browser tells it.
 *
 * @param {ResizeObserverEntry} entry
 */
function deviceSize(entry) {
  const about = { width_px: entry.contentRect.width * devicePixelRatio, height_px: entry.contentRect.height * devicePixelRatio };
  const exact = entry.devicePixelContentBoxSize?.[0];
  // It corrects a rounding; where it says something else altogether, the pixels it counts are not the page's.
  const isCorrection = exact && Math.abs(exact.inlineSize - about.width_px) < 2;
  const width_px = isCorrection ? exact.inlineSize : about.width_px;
  const height_px = isCorrection ? exact.blockSize : about.height_px;
  return { width_px: Math.max(1, Math.round(width_px)), height_px: Math.max(1, Math.round(height_px)) };
}
