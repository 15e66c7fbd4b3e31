/** Chance that comes out the same for the same seed. */
export class Chance {
  #state;

  /** @param {number} seed an integer */
  constructor(seed) {
    this.#state = seed >>> 0;
  }

  /** Evenly from 0 up to, not including, 1: mulberry32. */
  next() {
    this.#state = (this.#state + 0x6d2b79f5) >>> 0;
    let mixed = this.#state;
    mixed = Math.imul(mixed ^ (mixed >>> 15), mixed | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  }

  /** @param {number} share how often it is true */
  is(share) {
    return this.next() < share;
  }

  /** @param {number} count one of 0 … count − 1 */
  below(count) {
    return Math.floor(this.next() * count);
  }

  /**
   * @param {number} from
   * @param {number} to
   */
  between(from, to) {
    return from + (to - from) * this.next();
  }

  /**
   * @template T
   * @param {readonly T[]} list
   * @returns {T}
   */
  one(list) {
    return list[this.below(list.length)];
  }

  /**
   * One of the values, each as often as its weight says.
   *
   * @template T
   * @param {readonly (readonly [number, T])[]} weighted
   * @returns {T}
   */
  weighted(weighted) {
    let left = this.next() * weighted.reduce((sum, [weight]) => sum + weight, 0);
    for (const [weight, value] of weighted) {
      left -= weight;
      if (left < 0) return value;
    }
    return weighted.at(-1)[1];
  }
}
