/**
 * The middle of the rectangle around a face's landmarks, and its longer side, in px of the picture.
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

/** How much of the photo around the face is shown, in sizes of the face. */
const AROUND_FACE = 1.6;

/**
 * The part of a picture that shows a face with something of what is around it, in whole px.
 *
 * @param {Float32Array} landmarks
 * @param {{ width: number, height: number }} picture px
 */
export function aroundFace(landmarks, picture) {
  const { x, y, side: size } = faceBox(landmarks, picture.width, picture.height);
  const side = Math.ceil(AROUND_FACE * size);
  const width = Math.min(side, picture.width);
  const height = Math.min(side, picture.height);
  return {
    left: within(Math.round(x - width / 2), picture.width - width),
    top: within(Math.round(y - height / 2), picture.height - height),
    width,
    height,
  };
}

/**
 * @param {number} value
 * @param {number} most
 */
function within(value, most) {
  return Math.min(Math.max(value, 0), most);
}
