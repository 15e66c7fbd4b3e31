import { asPageError } from "../page/page-error.ts";
import { afterNextFrame, nextTask } from "../page/tasks.ts";
import { isTrap, markTrapped, openStudio, restartingError, restartStudio, studioModule, watchWebGl } from "../studio-module.ts";
import { followGpu } from "./device-loss.ts";
import { followSize } from "./size.ts";
import type { Applied, Catalogue, Changed, Intent, State, Studio, Tick, Widget } from "../../wasm/rosto-studio-web.js";

/** Shows and hides notices of an owner. */
export interface Notices {
  show: (thrown: unknown, owner: "studio" | "gpu") => void;
  hide: (owner: "studio" | "gpu") => void;
  /** Offers to load a module again that did not arrive. If omitted, {@link Host.open} throws. */
  offerRetry?: (thrown: unknown, retry: () => void) => void;
}

/** Arguments of the listeners of each event. */
interface Events {
  /** After each change of the document or of a choice. */
  change: State;
  /** After each change, and for each tick of an edit in progress. */
  tick: Tick;
  /** After each intent. */
  applied: Applied;
  /** After each change of the canvas's size or the device-pixel ratio, and after a restart. */
  size: undefined;
  /** After each drawn frame. */
  frame: undefined;
  /** When the photo has followed the edits, at most once per frame. */
  photo: undefined;
  /** The widgets of the panels that have changed. */
  panel: Widget[];
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
  /** Ids and ranges, which do not change. */
  readonly catalogue: Catalogue = studioModule().catalogue();
  /** The same object until a restart replaces the studio. */
  instance = {};
  #isBroken = false;
  #restarts_ms: number[] = [];
  #restorers: (() => Promise<void>)[] = [];
  #listeners = new Map<keyof Events, ((value: never) => void)[]>();
  #frameIsPending = false;
  #photoIsPending = false;
  #closed = new AbortController();
  #gpu;
  #fitSize;

  /**
   * Opens a studio on the canvas. Throws `{code: "no-webgl", …}` if the browser cannot draw in 3D. If the module does
   * not arrive, loads it again on request or when the browser is online again.
   */
  static async open(canvas: HTMLCanvasElement, notices: Notices): Promise<Host> {
    try {
      return new Host(canvas, await openStudio(canvas), notices);
    } catch (error) {
      const { offerRetry } = notices;
      if (!offerRetry || asPageError(error).code !== "not-loaded") throw error;
      await new Promise<void>((retry) => {
        addEventListener("online", () => retry(), { once: true });
        offerRetry(error, retry);
      });
      notices.hide("studio");
      return Host.open(canvas, notices);
    }
  }

  /** Open hosts, which share one module. */
  static #open = new Set<Host>();
  /** Handled traps; several hosts may report the same one. */
  static #handledTraps = new WeakSet<Error>();

  private constructor(
    readonly canvas: HTMLCanvasElement,
    private studio: Studio,
    private readonly notices: Notices,
  ) {
    this.#gpu = followGpu(this, notices);
    this.#fitSize = followSize(canvas, (size_px) => {
      this.apply({ resize: [size_px, devicePixelRatio] });
      this.#emit("size", undefined);
    }, this.closed);
    Host.#open.add(this);
  }

  /** Aborted when the host closes. */
  get closed() {
    return this.#closed.signal;
  }

  /** Frees the studio and its GPU resources. The canvas cannot be used again. */
  close() {
    if (this.closed.aborted) return;
    this.#closed.abort();
    Host.#open.delete(this);
    if (!this.#isBroken) this.studio.free();
    this.#isBroken = true;
    this.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /** Calls `listener` for each event of this name. */
  on<Name extends keyof Events>(name: Name, listener: (value: Events[Name]) => void) {
    this.#listeners.set(name, [...(this.#listeners.get(name) ?? []), listener]);
  }

  /** Calls `restore` after a restart, which restores the work. */
  onRestart(restore: () => Promise<void>) {
    this.#restorers.push(restore);
  }

  #emit<Name extends keyof Events>(name: Name, value: Events[Name]) {
    for (const listener of this.#listeners.get(name) ?? []) this.ask(() => listener(value as never));
  }

  /**
   * Applies an intent, notifies the listeners of the change, and shows errors. Returns the studio's answer; undefined
   * after an error or during a restart.
   */
  apply(intent: Intent) {
    return this.ask(() => this.attempt(intent));
  }

  /** Like {@link apply}, but throws errors. */
  attempt(intent: Intent) {
    const applied = this.answer((studio) => studio.apply(intent));
    this.#follow(applied.changed);
    this.#emit("applied", applied);
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
    this.ask(() => this.perform(call));
  }

  /** Like {@link act}, but throws errors. */
  perform(call: (studio: Studio) => Changed | void) {
    this.#follow(this.answer(call));
  }

  #follow(changed: Changed | void) {
    if (changed !== "nothing") this.requestFrame();
    if (changed === "document" || changed === "mesh") this.announce();
    else if (changed === "tick") this.#announceTick();
    else return;
    this.updatePhoto();
  }

  /** Returns the studio's answer. Throws its errors, and `{code: "restarting", …}` during a restart. */
  answer<T>(question: (studio: Studio) => T): T {
    if (this.#isBroken) throw restartingError();
    try {
      return question(this.studio);
    } catch (error) {
      // Immediately, so that no other caller enters the module.
      if (isTrap(error)) this.fail(error);
      throw error;
    }
  }

  /** Returns the studio's answer; undefined after an error, which is shown, or during a restart. */
  ask<T>(question: (studio: Studio) => T): T | undefined {
    if (this.#isBroken) return undefined;
    try {
      return this.answer(question);
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  /** Reads from the state; undefined after an error or during a restart. */
  read<T>(take: (state: State, studio: Studio) => T): T | undefined {
    return this.ask((studio) => take(studio.state(), studio));
  }

  /** Draws a picture and returns its pixels. */
  async picture(draw: (studio: Studio) => ReturnType<Studio["snapshot"]>) {
    const { instance } = this;
    const check = watchWebGl(this.canvas);
    const picture = await this.answer(draw);
    if (instance !== this.instance) throw restartingError();
    check();
    return picture;
  }

  /** Shows an error of the studio. After a trap, restarts all hosts. */
  fail(error: unknown) {
    if (!isTrap(error)) {
      const isLate = asPageError(error).code === "restarting";
      if (isLate === this.#isBroken) this.notices.show(error, "studio");
    } else if (!Host.#handledTraps.has(error)) {
      Host.#handledTraps.add(error);
      markTrapped();
      for (const host of Host.#open) host.#restart(error);
    }
  }

  /** Notifies all listeners of the state. */
  announce() {
    const state = this.ask((studio) => studio.state());
    if (!state) return;
    this.#emit("change", state);
    this.#emit("tick", state.tick);
    this.#showPanels(false);
  }

  #announceTick() {
    const tick = this.ask((studio) => studio.tick());
    if (!tick) return;
    this.#emit("tick", tick);
    this.#showPanels(true);
  }

  /** @param isTick whether only the edit in progress has changed */
  #showPanels(isTick: boolean) {
    if (!this.#listeners.has("panel")) return;
    const widgets = this.ask((studio) => studio.panelDiff(isTick))?.widgets ?? [];
    if (widgets.length > 0) this.#emit("panel", widgets);
  }

  /** Updates the edited photo. The factorisation and the listeners run in separate tasks to keep the page responsive. */
  async updatePhoto() {
    if (this.#photoIsPending) return;
    this.#photoIsPending = true;
    await afterNextFrame();
    this.#photoIsPending = false;
    if (this.ask((studio) => studio.photoIsDue)) this.act((studio) => studio.followPhoto());
    this.requestFrame();
    await nextTask();
    this.#emit("photo", undefined);
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

  #draw(time_ms: number) {
    if (!this.#gpu.isAvailable || this.#isBroken) return;
    try {
      const wantsMore = this.answer((studio) => studio.draw(time_ms));
      this.#emit("frame", undefined);
      if (wantsMore) this.requestFrame();
    } catch (error) {
      if (asPageError(error).code !== "device-lost") this.fail(error);
    }
  }

  /** Starts a new instance: after a trap the module's memory may be corrupt. */
  async #restart(trap: Error) {
    if (this.#isBroken) return;
    this.#isBroken = true;
    this.instance = {};
    console.warn("restarting the module after a trap:", trap);
    const { message } = trap;
    const now_ms = performance.now();
    this.#restarts_ms = [...this.#restarts_ms.filter((at_ms) => now_ms - at_ms < RESTARTS_WITHIN_MS), now_ms];
    try {
      if (this.#restarts_ms.length > MAX_RESTARTS) throw { code: "internal", message, hint: "" };
      const studio = await restartStudio(this.canvas);
      if (this.closed.aborted) return studio.free();
      this.studio = studio;
      this.#isBroken = false;
      this.#gpu.watch();
      this.#fitSize();
      for (const restore of this.#restorers) await restore();
      this.announce();
      this.updatePhoto();
      this.notices.hide("gpu");
      this.notices.show({ code: "restarted", message, hint: "" }, "studio");
    } catch (error) {
      this.notices.show(error, "studio");
    }
  }
}
