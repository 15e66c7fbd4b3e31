/** @typedef {import("../viewport/host.js").Host} Host */

/** To each side: far enough for a profile's line, and the hollow behind the face is not seen. */
const SWING = (35 * Math.PI) / 180;

/** Turns the face to one side, to the other and back to where it was, as smoothly as a pendulum. */
export class Swing {
  #host;
  #instance;
  /** From where it was at first, in radians. */
  #turned = 0;
  /** Whether it turned by itself before. */
  #turntable;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#instance = host.instance;
    this.#turntable = host.read(({ turntable }) => turntable) ?? false;
    if (this.#turntable) host.act((studio) => studio.setTurntable(false));
  }

  /** @param {number} share of the way there and back, 0 to 1 */
  go(share) {
    this.#turnTo(-SWING * Math.sin(2 * Math.PI * share));
  }

  /** @param {boolean} turnsBack not where another face has come, which is seen from the front */
  end(turnsBack) {
    if (this.#host.instance !== this.#instance) return;
    if (turnsBack) this.#turnTo(0);
    if (this.#turntable) this.#host.act((studio) => studio.setTurntable(true));
  }

  /** @param {number} radians */
  #turnTo(radians) {
    // Half a turn is a drag over the canvas' height, however high it is by now.
    const drag_px = ((radians - this.#turned) * this.#host.canvas.height) / Math.PI;
    this.#turned = radians;
    this.#host.act((studio) => studio.orbit(drag_px, 0));
  }
}
