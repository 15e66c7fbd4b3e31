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

/** Side of the crop relative to the face. */
const CROP_SCALE = 1.6;

/**
 * Crop of a picture around a face, with a margin, in whole px.
 *
 * @param picture px
 */
export function faceCrop(landmarks: Float32Array, picture: { width: number; height: number; }) {
  const { x, y, side: size } = faceBox(landmarks, picture.width, picture.height);
  const side = Math.ceil(CROP_SCALE * size);
  const width = Math.min(side, picture.width);
  const height = Math.min(side, picture.height);
  return {
    left: clamp(Math.round(x - width / 2), picture.width - width),
    top: clamp(Math.round(y - height / 2), picture.height - height),
    width,
    height,
  };
}

function clamp(value: number, max: number) {
  return Math.min(Math.max(value, 0), max);
}
