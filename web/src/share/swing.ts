import type { Host } from "../viewport/host.ts";

/** Amplitude: far enough to show the profile, without exposing the open back of the face. */
const AMPLITUDE = (35 * Math.PI) / 180;

/** Rotates the view to one side, to the other and back, as a sine. */
export class Swing {
  #host;
  #instance;
  /** Current angle relative to the start, in radians. */
  #angle = 0;
  /** Whether auto-rotate was on before. */
  #turntable;

  constructor(host: Host) {
    this.#host = host;
    this.#instance = host.instance;
    this.#turntable = host.read(({ turntable }) => turntable) ?? false;
    if (this.#turntable) host.apply({ turntable: false });
  }

  /** @param phase of the swing, 0 to 1 */
  setPhase(phase: number) {
    this.#rotateTo(-AMPLITUDE * Math.sin(2 * Math.PI * phase));
  }

  /** @param restoresView false after another face was opened, which resets the view */
  end(restoresView: boolean) {
    if (this.#host.instance !== this.#instance) return;
    if (restoresView) this.#rotateTo(0);
    if (this.#turntable) this.#host.apply({ turntable: true });
  }

  /** @param angle radians */
  #rotateTo(angle: number) {
    // A drag over the canvas' current height rotates by 180°.
    const drag_px = ((angle - this.#angle) * this.#host.canvas.height) / Math.PI;
    this.#angle = angle;
    this.#host.apply({ orbit: [drag_px, 0] });
  }
}
