/**
 * Centre and longer side of the landmarks' bounding box, in px of the picture.
 *
 * @param {Float32Array} landmarks
 * @param {number} width px of the picture
 * @param {number} height
 */
export function faceBox(landmarks, width, height) {
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
 * @param {Float32Array} landmarks
 * @param {{ width: number, height: number }} picture px
 */
export function faceCrop(landmarks, picture) {
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

/**
 * @param {number} value
 * @param {number} max
 */
function clamp(value, max) {
  return Math.min(Math.max(value, 0), max);
}
