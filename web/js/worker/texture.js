/**
 * Makes the whole-face texture.
 *
 * @typedef {import("./protocol.js").TextureTask} TextureTask
 */
import { TextureMaker } from "../../wasm/rosto-vision-web.js";

/**
 * @param {TextureTask} face
 * @returns {Uint8Array} RGBA
 */
export function textureOf({ plan, pictures, side_px }) {
  const maker = new TextureMaker(plan);
  try {
    for (const { pixels, width_px, height_px } of pictures) maker.addPicture(width_px, height_px, pixels);
    return maker.make(side_px);
  } finally {
    maker.free();
  }
}
