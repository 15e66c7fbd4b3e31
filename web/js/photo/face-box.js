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
