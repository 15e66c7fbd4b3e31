/** @typedef {(point: number) => { x: number, y: number }} PositionOf a point on the canvas, in canvas px */

/** Landmarks of the face; the iris points follow. */
export const LANDMARK_COUNT = 468;
const IRIS_POINTS = 5;

/**
 * Draws landmarks as white dots with a dark border, visible on any skin tone, and irises as circles.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {PositionOf} positionOf
 * @param {number} count of points, including the irises
 * @param {number} ratio device-pixel ratio
 */
export function drawLandmarks(context, positionOf, count, ratio) {
  for (const [colour, size] of /** @type {const} */ ([["rgb(0 0 0 / 0.45)", 3], ["rgb(255 255 255)", 1.5]])) {
    context.fillStyle = colour;
    for (let landmark = 0; landmark < LANDMARK_COUNT; landmark++) {
      const { x, y } = positionOf(landmark);
      context.fillRect(x - (size / 2) * ratio, y - (size / 2) * ratio, size * ratio, size * ratio);
    }
    for (const iris of irises(positionOf, count)) {
      context.strokeStyle = colour;
      context.lineWidth = (size / 2) * ratio;
      context.stroke(iris);
    }
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ x: number, y: number }} centre
 * @param {number} radius canvas px
 * @param {number} width canvas px
 */
export function drawCircle(context, { x, y }, radius, width) {
  context.strokeStyle = getComputedStyle(context.canvas).color;
  context.lineWidth = width;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
}

/**
 * Circles around the iris centres, with the mean distance of the four border points as radius; empty without irises.
 *
 * @param {PositionOf} positionOf
 * @param {number} count
 */
function irises(positionOf, count) {
  const circles = [];
  for (let iris = LANDMARK_COUNT; iris + IRIS_POINTS <= count; iris += IRIS_POINTS) {
    const centre = positionOf(iris);
    const border = [1, 2, 3, 4].map((point) => positionOf(iris + point));
    const radius = border.reduce((sum, { x, y }) => sum + Math.hypot(x - centre.x, y - centre.y) / border.length, 0);
    const circle = new Path2D();
    circle.arc(centre.x, centre.y, radius, 0, 2 * Math.PI);
    circles.push(circle);
  }
  return circles;
}
