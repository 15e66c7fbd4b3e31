/** @typedef {(point: number) => { x: number, y: number }} Place of a point on the canvas, in its px */

/** Behind these come the points of the irises. */
export const LANDMARK_COUNT = 468;
const IRIS_POINTS = 5;

/**
 * Landmarks as light dots in dark rings, which show on any skin, and irises as circles.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Place} place
 * @param {number} count of points, those of the irises among them
 * @param {number} ratio device px per CSS px
 */
export function drawLandmarks(context, place, count, ratio) {
  for (const [colour, size] of /** @type {const} */ ([["rgb(0 0 0 / 0.45)", 3], ["rgb(255 255 255)", 1.5]])) {
    context.fillStyle = colour;
    for (let landmark = 0; landmark < LANDMARK_COUNT; landmark++) {
      const { x, y } = place(landmark);
      context.fillRect(x - (size / 2) * ratio, y - (size / 2) * ratio, size * ratio, size * ratio);
    }
    for (const iris of irises(place, count)) {
      context.strokeStyle = colour;
      context.lineWidth = (size / 2) * ratio;
      context.stroke(iris);
    }
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ x: number, y: number }} middle
 * @param {number} radius px of the canvas
 * @param {number} width
 */
export function ring(context, { x, y }, radius, width) {
  context.strokeStyle = getComputedStyle(context.canvas).color;
  context.lineWidth = width;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
}

/**
 * The irises as circles around their middles, through the four points on their borders; none where none were found.
 *
 * @param {Place} place
 * @param {number} count
 */
function irises(place, count) {
  const circles = [];
  for (let iris = LANDMARK_COUNT; iris + IRIS_POINTS <= count; iris += IRIS_POINTS) {
    const middle = place(iris);
    const border = [1, 2, 3, 4].map((point) => place(iris + point));
    const radius = border.reduce((sum, { x, y }) => sum + Math.hypot(x - middle.x, y - middle.y) / border.length, 0);
    const circle = new Path2D();
    circle.arc(middle.x, middle.y, radius, 0, 2 * Math.PI);
    circles.push(circle);
  }
  return circles;
}
