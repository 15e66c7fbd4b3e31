import { asPageError } from "../page/page-error.js";
import { afterNextFrame, nextTask } from "../page/tasks.js";
import { DeviceLossHandler } from "./device-loss.js";
import { isTrap, markTrapped, openStudio, restartingError, restartStudio, studioModule } from "../../src/studio-module.ts";
import { watchWebGl } from "./webgl-errors.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {import("../../wasm/rosto-studio-web.js").State} State
 * @typedef {import("../../wasm/rosto-studio-web.js").Tick} Tick
 * @typedef {import("../../wasm/rosto-studio-web.js").Changed} Changed
 * @typedef {import("../../wasm/rosto-studio-web.js").Intent} Intent
 * @typedef {import("../../wasm/rosto-studio-web.js").Widget} Widget
 * @typedef {import("../../wasm/rosto-studio-web.js").Phrase} Phrase
 *
 * @typedef {object} Notices
 * @property {(thrown: unknown, owner: "studio" | "gpu") => void} show
 * @property {(owner: "studio" | "gpu") => void} hide hides that owner's notice only
 */

/**
 * @template T
 * @typedef {object} Lease wasm object that outlives a task
 * @property {<A>(question: (object: T) => A) => A} ask throws after a trap of the module
 * @property {() => void} end
 */

/** Maximum number of restarts per minute. */
const MAX_RESTARTS = 3;
const RESTARTS_WITHIN_MS = 60_000;

/**
 * Owns the studio, and with it the user's work, and notifies the page of changes. Draws in animation frames, and only
 * if something has changed. Replaces the studio after a trap of its module. Other code applies intents, and reaches the
 * studio's methods through `act`, `ask` and `answer`, for the length of one call.
 */
export class Host {
  #frameIsPending = false;
  #isBroken = false;
  #studio;
  /** Identifies the studio: replaced when its module traps. */
  #instance = {};
  /** @type {number[]} times of the restarts, in ms */
  #restarts = [];
  #gpu;
  /** @type {Set<(state: State) => void>} */
  #changeListeners = new Set();
  /** @type {Set<(tick: Tick) => void>} */
  #tickListeners = new Set();
  /** @type {Set<() => void>} */
  #frameListeners = new Set();
  /** @type {Set<() => void>} */
  #photoListeners = new Set();
  /** @type {Set<(widgets: Widget[]) => void>} */
  #panelListeners = new Set();
  /** @type {(said: Phrase) => void} */
  #say = () => {};
  #photoIsPending = false;
  #closed = new AbortController();
  #notices;
  /** @type {Set<() => Promise<void>>} */
  #restartListeners = new Set();

  /**
   * Opens a studio on the canvas. Throws `{code: "no-webgl", …}` if the browser cannot draw in 3D.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Notices} notices
   */
  static async open(canvas, notices) {
    return new Host(canvas, await openStudio(canvas), notices);
  }

  /** Open hosts, which share one module. @type {Set<Host>} */
  static #open = new Set();
  /** Handled traps; several hosts may report the same one. @type {WeakSet<Error>} */
  static #handledTraps = new WeakSet();

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Studio} studio
   * @param {Notices} notices
   */
  constructor(canvas, studio, notices) {
    this.canvas = canvas;
    this.#studio = studio;
    /** Ids and ranges, which do not change. */
    this.catalogue = studioModule().catalogue();
    this.#notices = notices;
    this.#gpu = new DeviceLossHandler(this, notices);
    this.#followSize();
    Host.#open.add(this);
  }

  /** Aborted when the host closes. */
  get closed() {
    return this.#closed.signal;
  }

  /** The same object until a restart replaces the studio. */
  get instance() {
    return this.#instance;
  }

  /** Frees the studio and its GPU resources. The canvas cannot be used again. */
  close() {
    if (this.closed.aborted) return;
    const isFree = !this.#isBroken;
    this.#isBroken = true;
    this.#closed.abort();
    Host.#open.delete(this);
    if (isFree) this.#studio.free();
    this.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /**
   * Applies an intent, notifies the listeners of the change, and shows errors. Returns the studio's answer; undefined
   * after an error or during a restart.
   *
   * @param {Intent} intent
   */
  apply(intent) {
    return this.#guarded(() => this.attempt(intent));
  }

  /**
   * Like {@link apply}, but throws errors.
   *
   * @param {Intent} intent
   */
  attempt(intent) {
    const applied = this.answer((studio) => studio.apply(intent));
    this.#follow(applied.changed);
    if (applied.said) this.#say(applied.said);
    return applied;
  }

  /**
   * Like {@link apply}, for an intent of a panel: shows the panels again, also if only the view has changed.
   *
   * @param {Intent} intent
   */
  applyShown(intent) {
    const changed = this.apply(intent)?.changed;
    // Other changes have shown them.
    if (changed === "view" || changed === undefined) this.#showPanels(false);
  }

  /**
   * Calls a method that changes the studio, notifies the listeners of the change, and shows errors.
   *
   * @param {(studio: Studio) => Changed | void} call
   */
  act(call) {
    this.#guarded(() => this.perform(call));
  }

  /**
   * Like {@link act}, but throws errors.
   *
   * @param {(studio: Studio) => Changed | void} call
   */
  perform(call) {
    this.#follow(this.answer(call));
  }

  /** @param {Changed | void} changed */
  #follow(changed) {
    const isDocument = changed === "document" || changed === "mesh";
    if (changed !== "nothing") this.requestFrame();
    if (isDocument) this.announce();
    if (changed === "tick") this.#notifyTick();
    if (isDocument || changed === "tick") this.updatePhoto();
  }

  /**
   * Returns the studio's answer; undefined after an error or during a restart.
   *
   * @template T
   * @param {(studio: Studio) => T} question
   * @returns {T | undefined}
   */
  ask(question) {
    return this.#guarded(() => this.answer(question));
  }

  /**
   * Shows errors; undefined after an error or during a restart.
   *
   * @template T
   * @param {() => T} call
   * @returns {T | undefined}
   */
  #guarded(call) {
    if (this.#isBroken) return undefined;
    try {
      return call();
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /**
   * Returns the studio's answer. Throws its errors, and `{code: "restarting", …}` during a restart.
   *
   * @template T
   * @param {(studio: Studio) => T} question
   * @returns {T}
   */
  answer(question) {
    if (this.#isBroken) throw restartingError();
    try {
      return question(this.#studio);
    } catch (error) {
      // Immediately, so that no other caller enters the module.
      if (isTrap(error)) this.fail(error);
      throw error;
    }
  }

  /**
   * Draws a picture and returns its pixels.
   *
   * @param {(studio: Studio) => ReturnType<Studio["snapshot"]>} draw
   */
  async picture(draw) {
    const instance = this.#instance;
    const check = watchWebGl(this.canvas);
    const picture = await this.answer(draw);
    if (instance !== this.#instance) throw restartingError();
    check();
    return picture;
  }

  /**
   * Wraps a wasm object that is used in several tasks.
   *
   * @template {{ free: () => void }} T
   * @param {(studio: Studio) => T} make
   * @returns {Lease<T>}
   */
  lease(make) {
    const [object, instance] = [this.answer(make), this.#instance];
    return {
      ask: (question) => {
        if (instance !== this.#instance) throw restartingError();
        return this.answer(() => question(object));
      },
      end: () => object.free(),
    };
  }

  /**
   * Reads from the state; undefined after an error or during a restart.
   *
   * @template T
   * @param {(state: State, studio: Studio) => T} take
   * @returns {T | undefined}
   */
  read(take) {
    return this.ask((studio) => take(studio.state(), studio));
  }

  /**
   * Shows an error of the studio. After a trap, restarts all hosts.
   *
   * @param {unknown} error
   */
  fail(error) {
    if (!isTrap(error)) {
      const isLate = asPageError(error).code === "restarting";
      if (isLate === this.#isBroken) this.#notices.show(error, "studio");
    } else if (!Host.#handledTraps.has(error)) {
      Host.#handledTraps.add(error);
      markTrapped();
      for (const host of Host.#open) host.#restart(error);
    }
  }

  /** @param {(state: State) => void} listener called after each change of the document or of a choice */
  onChange(listener) {
    this.#changeListeners.add(listener);
  }

  /** @param {(tick: Tick) => void} listener called after each change, and for each tick of an edit in progress */
  onTick(listener) {
    this.#tickListeners.add(listener);
  }

  /** @param {() => void} listener called after each drawn frame */
  onFrame(listener) {
    this.#frameListeners.add(listener);
  }

  /** @param {() => void} listener called when the photo has followed the edits, at most once per frame */
  onPhoto(listener) {
    this.#photoListeners.add(listener);
  }

  /** @param {(widgets: Widget[]) => void} listener called with the widgets of the panels that have changed */
  onPanel(listener) {
    this.#panelListeners.add(listener);
  }

  /** @param {(said: Phrase) => void} listener called with announcements for screen readers */
  onSaid(listener) {
    this.#say = listener;
  }

  /** @param {() => Promise<void>} listener restores the work after a restart */
  onRestart(listener) {
    this.#restartListeners.add(listener);
  }

  /** Notifies all change and tick listeners. */
  announce() {
    const state = this.ask((studio) => studio.state());
    if (!state) return;
    for (const listener of this.#changeListeners) this.ask(() => listener(state));
    for (const listener of this.#tickListeners) this.ask(() => listener(state.tick));
    this.#showPanels(false);
  }

  /** @param {boolean} isTick whether only the edit in progress has changed */
  #showPanels(isTick) {
    if (this.#panelListeners.size === 0) return;
    const diff = this.ask((studio) => studio.panelDiff(isTick));
    if (diff && diff.widgets.length > 0) for (const listener of this.#panelListeners) this.ask(() => listener(diff.widgets));
  }

  /**
   * Updates the edited photo. The factorisation and the listeners run in separate tasks to keep the page responsive.
   */
  async updatePhoto() {
    if (this.#photoIsPending) return;
    this.#photoIsPending = true;
    await afterNextFrame();
    this.#photoIsPending = false;
    if (this.ask((studio) => studio.photoIsDue)) this.act((studio) => studio.followPhoto());
    this.requestFrame();
    await nextTask();
    for (const listener of this.#photoListeners) this.ask(() => listener());
    this.#showPanels(true);
  }

  /** Draws in the next animation frame. */
  requestFrame() {
    if (this.#frameIsPending) return;
    this.#frameIsPending = true;
    requestAnimationFrame((time_ms) => {
      this.#frameIsPending = false;
      this.#draw(time_ms);
    });
  }

  #notifyTick() {
    const tick = this.ask((studio) => studio.tick());
    if (!tick) return;
    for (const listener of this.#tickListeners) this.ask(() => listener(tick));
    this.#showPanels(true);
  }

  /** @param {number} time_ms */
  #draw(time_ms) {
    if (!this.#gpu.isAvailable || this.#isBroken) return;
    try {
      const wantsMore = this.answer((studio) => studio.draw(time_ms));
      for (const listener of this.#frameListeners) listener();
      if (wantsMore) this.requestFrame();
    } catch (error) {
      if (asPageError(error).code !== "device-lost") this.fail(error);
    }
  }

  /** Starts a new instance: after a trap the module's memory may be corrupt. @param {Error} trap */
  async #restart(trap) {
    if (this.#isBroken) return;
    this.#isBroken = true;
    this.#instance = {};
    console.warn("restarting the module after a trap:", trap);
    const now_ms = performance.now();
    this.#restarts = [...this.#restarts.filter((at_ms) => now_ms - at_ms < RESTARTS_WITHIN_MS), now_ms];
    try {
      if (this.#restarts.length > MAX_RESTARTS) throw { code: "internal", message: trap.message, hint: "" };
      const studio = await restartStudio(this.canvas);
      if (this.closed.aborted) return studio.free();
      this.#studio = studio;
      this.#isBroken = false;
      this.#gpu.watch();
      this.#fitSize?.();
      for (const listener of this.#restartListeners) await listener();
      this.announce();
      this.updatePhoto();
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
      this.#fitSize = () => this.apply({ resize: [[size.width_px, size.height_px], devicePixelRatio] });
      this.#fitSize();
    });
    observer.observe(this.canvas);
    this.closed.addEventListener("abort", () => observer.disconnect());
  }
}

/**
 * Size of the canvas in device pixels; exact if the browser reports it.
 *
 * @param {ResizeObserverEntry} entry
 */
function deviceSize(entry) {
  const about = { width_px: entry.contentRect.width * devicePixelRatio, height_px: entry.contentRect.height * devicePixelRatio };
  const exact = entry.devicePixelContentBoxSize?.[0];
  // Only corrects rounding: a larger difference means that the browser counts other pixels.
  const isCorrection = exact && Math.abs(exact.inlineSize - about.width_px) < 2;
  const width_px = isCorrection ? exact.inlineSize : about.width_px;
  const height_px = isCorrection ? exact.blockSize : about.height_px;
  return { width_px: Math.max(1, Math.round(width_px)), height_px: Math.max(1, Math.round(height_px)) };
}
