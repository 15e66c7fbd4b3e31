// In the browser: a file drawn by three.js as a camera sees it.
import { Matrix4, NoToneMapping, PerspectiveCamera, Scene, WebGLRenderer } from "three";
import { load } from "./three-reads.mjs";

/**
 * RGBA from the top left as base64, transparent outside the file. There is no light, so only unlit materials have colours.
 *
 * @param {string} url
 * @param {{ width: number, height: number, focal_px: number, cameraFromModel: number[] }} camera the matrix by columns; it
 *   looks along −Z through the middle of the picture
 */
export async function draw(url, { width, height, focal_px, cameraFromModel }) {
  const renderer = new WebGLRenderer({ alpha: true, antialias: false, preserveDrawingBuffer: true });
  renderer.toneMapping = NoToneMapping;
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  const upright_deg = (360 / Math.PI) * Math.atan(height / 2 / focal_px);
  const shown = await load(url);
  shown.applyMatrix4(new Matrix4().fromArray(cameraFromModel));
  renderer.render(new Scene().add(shown), new PerspectiveCamera(upright_deg, width / height, 0.01, 100));
  const context = new OffscreenCanvas(width, height).getContext("2d");
  context.drawImage(renderer.domElement, 0, 0);
  renderer.dispose();
  renderer.forceContextLoss();
  return base64(context.getImageData(0, 0, width, height).data);
}

/** Passing numbers one by one takes longer than drawing. @param {Uint8ClampedArray} bytes */
function base64(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}
