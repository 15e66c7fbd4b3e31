import { asPageError } from "../page/page-error.ts";
import { afterNextFrame, nextTask } from "../page/tasks.ts";
import { DeviceLossHandler } from "./device-loss.ts";
import { isTrap, markTrapped, openStudio, restartingError, restartStudio, studioModule } from "../studio-module.ts";
import { watchWebGl } from "./webgl-errors.ts";
import type { Catalogue, Changed, Intent, Phrase, State, Studio, Tick, Widget } from "../../wasm/rosto-studio-web.js";

export interface Notices {
  show: (thrown: unknown, owner: "studio" | "gpu") => void;
  /** hides that owner's notice only */
  hide: (owner: "studio" | "gpu") => void;
}

/** Wasm object that outlives a task. */
export interface Lease<T> {
  /** throws after a trap of the module */
  ask: <A>(question: (object: T) => A) => A;
  end: () => void;
}

/** Maximum number of restarts per minute. */
const MAX_RESTARTS = 3;
const RESTARTS_WITHIN_MS = 60_000;

/**
 * Owns the studio, and with it the user's work, and notifies the page of changes. Draws in animation frames, and only
 * if something has changed. Replaces the studio after a trap of its module. Other code applies intents, and reaches the
 * studio's methods through `act`, `ask` and `answer`, for the length of one call.
 */
export class Host {
  readonly canvas: HTMLCanvasElement;
  /** Ids and ranges, which do not change. */
  readonly catalogue: Catalogue;
  #frameIsPending = false;
  #isBroken = false;
  #studio;
  /** Identifies the studio: replaced when its module traps. */
  #instance = {};
  #restarts: number[] = [];
  #gpu;
  #changeListeners: Set<(state: State) => void> = new Set();
  #tickListeners: Set<(tick: Tick) => void> = new Set();
  #frameListeners: Set<() => void> = new Set();
  #photoListeners: Set<() => void> = new Set();
  #panelListeners: Set<(widgets: Widget[]) => void> = new Set();
  #say: (said: Phrase) => void = (): void => {};
  #photoIsPending = false;
  #closed = new AbortController();
  #notices;
  #restartListeners: Set<() => Promise<void>> = new Set();

  /** Opens a studio on the canvas. Throws `{code: "no-webgl", …}` if the browser cannot draw in 3D. */
  static async open(canvas: HTMLCanvasElement, notices: Notices) {
    return new Host(canvas, await openStudio(canvas), notices);
  }

  /** Open hosts, which share one module. */
  static #open: Set<Host> = new Set();
  /** Handled traps; several hosts may report the same one. */
  static #handledTraps: WeakSet<Error> = new WeakSet();

  constructor(canvas: HTMLCanvasElement, studio: Studio, notices: Notices) {
    this.canvas = canvas;
    this.#studio = studio;
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
   */
  apply(intent: Intent) {
    return this.#guarded(() => this.attempt(intent));
  }

  /** Like {@link apply}, but throws errors. */
  attempt(intent: Intent) {
    const applied = this.answer((studio) => studio.apply(intent));
    this.#follow(applied.changed);
    if (applied.said) this.#say(applied.said);
    return applied;
  }

  /** Like {@link apply}, for an intent of a panel: shows the panels again, also if only the view has changed. */
  applyShown(intent: Intent) {
    const changed = this.apply(intent)?.changed;
    // Other changes have shown them.
    if (changed === "view" || changed === undefined) this.#showPanels(false);
  }

  /** Calls a method that changes the studio, notifies the listeners of the change, and shows errors. */
  act(call: (studio: Studio) => Changed | void) {
    this.#guarded(() => this.perform(call));
  }

  /** Like {@link act}, but throws errors. */
  perform(call: (studio: Studio) => Changed | void) {
    this.#follow(this.answer(call));
  }

  #follow(changed: Changed | void) {
    const isDocument = changed === "document" || changed === "mesh";
    if (changed !== "nothing") this.requestFrame();
    if (isDocument) this.announce();
    if (changed === "tick") this.#notifyTick();
    if (isDocument || changed === "tick") this.updatePhoto();
  }

  /** Returns the studio's answer; undefined after an error or during a restart. */
  ask<T>(question: (studio: Studio) => T): T | undefined {
    return this.#guarded(() => this.answer(question));
  }

  /** Shows errors; undefined after an error or during a restart. */
  #guarded<T>(call: () => T): T | undefined {
    if (this.#isBroken) return undefined;
    try {
      return call();
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /** Returns the studio's answer. Throws its errors, and `{code: "restarting", …}` during a restart. */
  answer<T>(question: (studio: Studio) => T): T {
    if (this.#isBroken) throw restartingError();
    try {
      return question(this.#studio);
    } catch (error) {
      // Immediately, so that no other caller enters the module.
      if (isTrap(error)) this.fail(error);
      throw error;
    }
  }

  /** Draws a picture and returns its pixels. */
  async picture(draw: (studio: Studio) => ReturnType<Studio["snapshot"]>) {
    const instance = this.#instance;
    const check = watchWebGl(this.canvas);
    const picture = await this.answer(draw);
    if (instance !== this.#instance) throw restartingError();
    check();
    return picture;
  }

  /** Wraps a wasm object that is used in several tasks. */
  lease<T extends { free: () => void }>(make: (studio: Studio) => T): Lease<T> {
    const [object, instance] = [this.answer(make), this.#instance];
    return {
      ask: (question) => {
        if (instance !== this.#instance) throw restartingError();
        return this.answer(() => question(object));
      },
      end: () => object.free(),
    };
  }

  /** Reads from the state; undefined after an error or during a restart. */
  read<T>(take: (state: State, studio: Studio) => T): T | undefined {
    return this.ask((studio) => take(studio.state(), studio));
  }

  /** Shows an error of the studio. After a trap, restarts all hosts. */
  fail(error: unknown) {
    if (!isTrap(error)) {
      const isLate = asPageError(error).code === "restarting";
      if (isLate === this.#isBroken) this.#notices.show(error, "studio");
    } else if (!Host.#handledTraps.has(error)) {
      Host.#handledTraps.add(error);
      markTrapped();
      for (const host of Host.#open) host.#restart(error);
    }
  }

  /** @param listener called after each change of the document or of a choice */
  onChange(listener: (state: State) => void) {
    this.#changeListeners.add(listener);
  }

  /** @param listener called after each change, and for each tick of an edit in progress */
  onTick(listener: (tick: Tick) => void) {
    this.#tickListeners.add(listener);
  }

  /** @param listener called after each drawn frame */
  onFrame(listener: () => void) {
    this.#frameListeners.add(listener);
  }

  /** @param listener called when the photo has followed the edits, at most once per frame */
  onPhoto(listener: () => void) {
    this.#photoListeners.add(listener);
  }

  /** @param listener called with the widgets of the panels that have changed */
  onPanel(listener: (widgets: Widget[]) => void) {
    this.#panelListeners.add(listener);
  }

  /** @param listener called with announcements for screen readers */
  onSaid(listener: (said: Phrase) => void) {
    this.#say = listener;
  }

  /** @param listener restores the work after a restart */
  onRestart(listener: () => Promise<void>) {
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

  /** @param isTick whether only the edit in progress has changed */
  #showPanels(isTick: boolean) {
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

  #draw(time_ms: number) {
    if (!this.#gpu.isAvailable || this.#isBroken) return;
    try {
      const wantsMore = this.answer((studio) => studio.draw(time_ms));
      for (const listener of this.#frameListeners) listener();
      if (wantsMore) this.requestFrame();
    } catch (error) {
      if (asPageError(error).code !== "device-lost") this.fail(error);
    }
  }

  /** Starts a new instance: after a trap the module's memory may be corrupt. */
  async #restart(trap: Error) {
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

  #fitSize: (() => void) | undefined;

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

/** Size of the canvas in device pixels; exact if the browser reports it. */
function deviceSize(entry: ResizeObserverEntry) {
  const about = { width_px: entry.contentRect.width * devicePixelRatio, height_px: entry.contentRect.height * devicePixelRatio };
  const exact = entry.devicePixelContentBoxSize?.[0];
  // Only corrects rounding: a larger difference means that the browser counts other pixels.
  const isCorrection = exact && Math.abs(exact.inlineSize - about.width_px) < 2;
  const width_px = isCorrection ? exact.inlineSize : about.width_px;
  const height_px = isCorrection ? exact.blockSize : about.height_px;
  return { width_px: Math.max(1, Math.round(width_px)), height_px: Math.max(1, Math.round(height_px)) };
}
