import { byId } from "../page/dom.js";

/** @typedef {import("./host.js").Host} Host */

/**
 * What the brush keeps of the photo, tinted over the stage while the brush is in hand, and the brush itself under the pointer.
 *
 * @param {Host} host
 */
export function setUpBrushMarks(host) {
  const canvas = byId("kept", HTMLCanvasElement);
  /** @type {number | undefined} */
  let radius_px;
  /** @type {{ x: number, y: number } | undefined} */
  let pointer;
  const draw = () => {
    const isInHand = radius_px !== undefined;
    canvas.hidden = !isInHand;
    if (!isInHand) return;
    const { width, height } = host.canvas;
    Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    if (!context) return;
    const circles = host.ask((studio) => studio.keptOnCanvas()) ?? new Float32Array();
    context.fillStyle = hatching(context);
    context.beginPath();
    for (let at = 0; at < circles.length; at += 3) {
      const [x = 0, y = 0, radius = 0] = circles.subarray(at, at + 3);
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
    if (pointer) ring(context, pointer, radius_px ?? 0);
  };
  host.onChange(({ brushPx }) => {
    radius_px = brushPx;
    draw();
  });
  host.onFrame(draw);
  host.canvas.addEventListener("pointermove", (event) => {
    if (radius_px === undefined) return;
    // To ask where it is lays the page out anew: not with every move of a drag.
    pointer = { x: event.offsetX * devicePixelRatio, y: event.offsetY * devicePixelRatio };
    draw();
  });
  host.canvas.addEventListener("pointerleave", () => {
    pointer = undefined;
    draw();
  });
}

/**
 * Lines aslant, light and dark, are seen on any picture.
 *
 * @param {CanvasRenderingContext2D} context
 */
function hatching(context) {
  const side = 10;
  const tile = new OffscreenCanvas(side, side);
  const draw = tile.getContext("2d");
  if (!draw) return "rgb(255 255 255 / 0.4)";
  draw.fillStyle = "rgb(255 255 255 / 0.3)";
  draw.fillRect(0, 0, side, side);
  for (const [colour, shift] of /** @type {const} */ ([["rgb(0 0 0 / 0.55)", 0], ["rgb(255 255 255 / 0.9)", 2]])) {
    draw.strokeStyle = colour;
    draw.lineWidth = 1.5;
    for (const from of [-side, 0, side]) {
      draw.moveTo(from + shift, side);
      draw.lineTo(from + shift + side, 0);
    }
    draw.stroke();
    draw.beginPath();
  }
  return context.createPattern(tile, "repeat") ?? "rgb(255 255 255 / 0.4)";
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ x: number, y: number }} place
 * @param {number} radius_px CSS px
 */
function ring(context, { x, y }, radius_px) {
  for (const [colour, width] of /** @type {const} */ ([["rgb(0 0 0 / 0.5)", 3], ["rgb(255 255 255)", 1.5]])) {
    context.strokeStyle = colour;
    context.lineWidth = width * devicePixelRatio;
    context.beginPath();
    context.arc(x, y, radius_px * devicePixelRatio, 0, 2 * Math.PI);
    context.stroke();
  }
}
