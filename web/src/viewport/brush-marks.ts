import { byId } from "../page/dom.ts";
import type { Host } from "./host.ts";

/** Tints the areas that the brush protects, and draws the brush under the pointer. */
export function setUpBrushMarks(host: Host) {
  const canvas = byId("protected-areas", HTMLCanvasElement);
  let radius_px: number | undefined;
  let pointer: { x: number; y: number; } | undefined;
  const draw = () => {
    const isActive = radius_px !== undefined;
    canvas.hidden = !isActive;
    if (!isActive) return;
    const { width, height } = host.canvas;
    Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    if (!context) return;
    const circles = host.ask((studio) => studio.protectedOnCanvas()) ?? new Float32Array();
    context.fillStyle = stripes(context);
    context.beginPath();
    for (let index = 0; index < circles.length; index += 3) {
      const [x = 0, y = 0, radius = 0] = circles.subarray(index, index + 3);
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
    if (pointer) drawBrush(context, pointer, radius_px ?? 0);
  };
  host.on("change", ({ brushPx }) => {
    radius_px = brushPx;
    draw();
  });
  host.on("frame", draw);
  host.canvas.addEventListener("pointermove", (event) => {
    if (radius_px === undefined) return;
    // offsetX avoids a forced layout on each move.
    pointer = { x: event.offsetX * devicePixelRatio, y: event.offsetY * devicePixelRatio };
    draw();
  });
  host.canvas.addEventListener("pointerleave", () => {
    pointer = undefined;
    draw();
  });
}

/** Light and dark stripes, visible on any picture. */
function stripes(context: CanvasRenderingContext2D) {
  const side = 10;
  const tile = new OffscreenCanvas(side, side);
  const draw = tile.getContext("2d");
  if (!draw) return "rgb(255 255 255 / 0.4)";
  draw.fillStyle = "rgb(255 255 255 / 0.3)";
  draw.fillRect(0, 0, side, side);
  for (const [colour, shift] of ([["rgb(0 0 0 / 0.55)", 0], ["rgb(255 255 255 / 0.9)", 2]] as const)) {
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

/** @param radius_px CSS px */
function drawBrush(context: CanvasRenderingContext2D, { x, y }: { x: number; y: number; }, radius_px: number) {
  for (const [colour, width] of ([["rgb(0 0 0 / 0.5)", 3], ["rgb(255 255 255)", 1.5]] as const)) {
    context.strokeStyle = colour;
    context.lineWidth = width * devicePixelRatio;
    context.beginPath();
    context.arc(x, y, radius_px * devicePixelRatio, 0, 2 * Math.PI);
    context.stroke();
  }
}
