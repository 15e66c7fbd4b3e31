/** Position of a point on the canvas, in canvas px. */
type PositionOf = (point: number) => { x: number; y: number };

/** Landmarks of the face; the iris points follow. */
export const LANDMARK_COUNT = 468;
const IRIS_POINTS = 5;

/**
 * Draws landmarks as white dots with a dark border, visible on any skin tone, and irises as circles.
 *
 * @param count of points, including the irises
 * @param ratio device-pixel ratio
 */
export function drawLandmarks(context: CanvasRenderingContext2D, positionOf: PositionOf, count: number, ratio: number) {
  for (const [colour, size] of ([["rgb(0 0 0 / 0.45)", 3], ["rgb(255 255 255)", 1.5]] as const)) {
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
 * @param radius canvas px
 * @param width canvas px
 */
export function drawCircle(context: CanvasRenderingContext2D, { x, y }: { x: number; y: number; }, radius: number, width: number) {
  context.strokeStyle = getComputedStyle(context.canvas).color;
  context.lineWidth = width;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
}

/**
 * Circles around the iris centres, with the mean distance of the four border points as radius; empty without irises.
 */
function irises(positionOf: PositionOf, count: number) {
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
