/** The npm package. */
import type { RostoStudio } from "./element/rosto-studio.ts";

export { FaceSession } from "./element/face-session.ts";
export { RostoStudio } from "./element/rosto-studio.ts";
export { VisionClient } from "./photo/vision-client.ts";
export { Host } from "./viewport/host.ts";
export { init } from "./files.ts";

/** The state of an element; also the detail of the event `rosto-change`. */
export type StudioSnapshot = RostoStudio["state"];

/** Detail of the event `rosto-face`. */
export interface ShownFace {
  /** 478 × (x/W, y/H, z/W), MediaPipe's normalised convention, irises last. */
  landmarks: Float32Array;
  width_px: number;
  height_px: number;
  /** Number of faces in the photo. */
  faces: number;
  /** Index of this face, most prominent first. */
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
