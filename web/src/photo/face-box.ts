/** Side of the crop relative to the face: the head and the shoulders. */
const CROP_SCALE = 2.2;

/**
 * Centre and longer side of the landmarks' bounding box, in px of the picture.
 *
 * @param width px of the picture
 */
export function faceBox(landmarks: Float32Array, width: number, height: number) {
  const xs = landmarks.filter((_, at) => at % 3 === 0).map((x) => x * width);
  const ys = landmarks.filter((_, at) => at % 3 === 1).map((y) => y * height);
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { x: (left + right) / 2, y: (top + bottom) / 2, side: Math.max(right - left, bottom - top) };
}

/**
 * Crop of a picture around a face, with a margin, in whole px.
 *
 * @param picture px
 */
export function faceCrop(landmarks: Float32Array, picture: { width: number; height: number }) {
  const { x, y, side } = faceBox(landmarks, picture.width, picture.height);
  const [width, height] = [picture.width, picture.height].map((whole) => Math.min(Math.ceil(CROP_SCALE * side), whole));
  const left = Math.min(Math.max(Math.round(x - width / 2), 0), picture.width - width);
  const top = Math.min(Math.max(Math.round(y - height / 2), 0), picture.height - height);
  return { left, top, width, height };
}

/**
 * Square picture of a face.
 *
 * @param scale side of the crop relative to the face
 * @param side_px in CSS px
 */
export function faceThumbnail(picture: ImageBitmap, landmarks: Float32Array, scale: number, side_px: number) {
  const box = faceBox(landmarks, picture.width, picture.height);
  const side = Math.max(1, Math.round(scale * box.side));
  const [left, top] = [box.x, box.y].map((middle) => Math.round(middle - (scale * box.side) / 2));
  const size = Math.round(side_px * devicePixelRatio);
  const resize = { resizeWidth: size, resizeHeight: size, resizeQuality: "high" } as const;
  return createImageBitmap(picture, left, top, side, side, resize);
}
