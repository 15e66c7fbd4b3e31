/** Drawing on the 2D canvases of the photo. */

export type Drawable = ImageBitmap | OffscreenCanvas;

/** Position of a point, in px of the canvas. */
export type Place = { x: number; y: number };

/** Landmarks of the face; the iris points follow. */
export const LANDMARK_COUNT = 468;
const IRIS_POINTS = 5;

/**
 * Fills a canvas with a picture, or with its middle.
 *
 * @param width of the middle, in px of the picture
 */
export function fill(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  picture: Drawable,
  width = picture.width,
  height = picture.height,
) {
  const context = canvas.getContext("2d") as CanvasRenderingContext2D;
  context.imageSmoothingQuality = "high";
  const [left, top] = [(picture.width - width) / 2, (picture.height - height) / 2];
  context.drawImage(picture, left, top, width, height, 0, 0, canvas.width, canvas.height);
  return context;
}

/**
 * Draws landmarks as white dots with a dark border, visible on any skin tone, and irises as circles, with the mean
 * distance of the four border points as radius.
 *
 * @param places of the landmarks and the iris points
 * @param ratio device-pixel ratio
 */
export function drawLandmarks(context: CanvasRenderingContext2D, places: Place[], ratio: number) {
  for (const [colour, size] of [["rgb(0 0 0 / 0.45)", 3 * ratio], ["rgb(255 255 255)", 1.5 * ratio]] as const) {
    context.fillStyle = context.strokeStyle = colour;
    context.lineWidth = size / 2;
    for (const { x, y } of places.slice(0, LANDMARK_COUNT)) context.fillRect(x - size / 2, y - size / 2, size, size);
    for (let at = LANDMARK_COUNT; at + IRIS_POINTS <= places.length; at += IRIS_POINTS) {
      const [centre, ...border] = places.slice(at, at + IRIS_POINTS);
      const distances = border.map(({ x, y }) => Math.hypot(x - centre.x, y - centre.y));
      drawCircle(context, centre, distances.reduce((sum, each) => sum + each) / distances.length);
    }
  }
}

/** @param radius canvas px */
export function drawCircle(context: CanvasRenderingContext2D, { x, y }: Place, radius: number) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
}
