import { RostoStudio } from "./element/rosto-studio.js";
import type { StudioSnapshot } from "./element/state.js";

export { RostoStudio };
export type { StudioSnapshot };

/** What `rosto-face` tells of the face that is shown. */
export interface ShownFace {
  /** 478 × (x/W, y/H, z/W), MediaPipe's normalised convention; those of the irises last. */
  landmarks: Float32Array;
  width_px: number;
  height_px: number;
  /** How many faces the photo has, and which of them it is. */
  faces: number;
  index: number;
}

declare global {
  interface HTMLElementTagNameMap {
    "rosto-studio": RostoStudio;
  }
  interface GlobalEventHandlersEventMap {
    "rosto-ready": CustomEvent<null>;
    "rosto-face": CustomEvent<ShownFace>;
    "rosto-change": CustomEvent<StudioSnapshot>;
    "rosto-error": CustomEvent<{ code: string; message: string; hint: string }>;
  }
}
