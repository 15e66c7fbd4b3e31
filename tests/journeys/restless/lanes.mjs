import { launch } from "../browser.mjs";
import { Visitor } from "../visitor.mjs";
import { CONTEXT, Visit } from "./visit.mjs";

/** Each visit has a seed of its own, so that what it found can be found again quickly. */
const ACTIONS_PER_VISIT = 250;
const VISITS_PER_BROWSER = 12;

/** What all lanes have done together, and what is left to do. */
export class Run {
  /** @type {Map<string, { message: string, count: number, seeds: { seed: number, upto: number }[], stack?: string, last: string[], shortest?: string[] }>} */
  findings = new Map();
  /** Actions that were done. */
  done = 0;
  #left;
  #seed;

  /** @param {number} wanted actions @param {number} seed of the first visit @param {number} until in ms, as performance.now() tells */
  constructor(wanted, seed, until) {
    this.#left = wanted;
    this.#seed = seed;
    this.until = until;
  }

  /** The next visit, while there is time and something left to do. */
  next() {
    const count = Math.min(ACTIONS_PER_VISIT, this.#left);
    if (count <= 0 || performance.now() > this.until) return undefined;
    this.#left -= count;
    return { seed: this.#seed++, count };
  }

  /** A visit is over; what a finding has cut off is left for others. @param {number} count @param {number} done */
  finish(count, done) {
    this.done += done;
    this.#left += count - done;
  }
}

/** Visits to the page, each in a context of its own, and in a fresh browser now and then. */
export class Visits {
  /** @type {import("playwright-core").Browser | undefined} */
  #browser;
  #count = 0;

  /** @param {string} url of the page @param {string} film what the camera shows */
  constructor(url, film) {
    this.url = url;
    this.film = film;
  }

  /** @param {Parameters<Visit["go"]>[0]} wishes @param {Parameters<Visit["go"]>[1]} how */
  async make(wishes, how) {
    if (this.#count++ % VISITS_PER_BROWSER === 0 || !this.#browser?.isConnected()) {
      await this.end();
      this.#browser = await launch({ film: this.film });
    }
    const visitor = await Visitor.arrive(this.#browser, this.url, CONTEXT);
    try {
      return await (await Visit.of(visitor)).go(wishes, how);
    } finally {
      await visitor.leave().catch(() => {});
    }
  }

  async end() {
    await this.#browser?.close().catch(() => {});
  }
}
