import { byId } from "../page/dom.ts";
import type { Host } from "./host.ts";

/** Elements that stay over the stage. */
const OVERLAY_IDS = ["faces", "privacy", "toolbar", "live"];

/** Distance between the face and these elements, in CSS px. */
const MARGIN_PX = 8;

/** Distance of the stripes in protected areas. They are light and dark, and so visible on any picture. */
const STRIPE_PX = 10;
const STRIPES = [["rgb(0 0 0 / 0.55)", 0], ["rgb(255 255 255 / 0.9)", 2]] as const;
const RINGS = [["rgb(0 0 0 / 0.5)", 3], ["rgb(255 255 255)", 1.5]] as const;

/** Updates the viewport insets, so that the face is framed in the uncovered part of the stage. */
export function setUpViewportInsets(host: Host) {
  const photo = byId("photo-pane", HTMLButtonElement);
  const overlays = OVERLAY_IDS.map((id) => byId(id, HTMLElement));
  const apply = () => {
    const stage = host.canvas.getBoundingClientRect();
    let [above, below] = [0, 0];
    for (const overlay of overlays.filter((overlay) => overlay.checkVisibility())) {
      const { top, bottom } = overlay.getBoundingClientRect();
      if (top + bottom < stage.top + stage.bottom) above = Math.max(above, bottom + MARGIN_PX - stage.top);
      else below = Math.max(below, stage.bottom + MARGIN_PX - top);
    }
    const before = photo.hidden ? 0 : photo.getBoundingClientRect().right - stage.left;
    const ratio = devicePixelRatio;
    host.apply({ "viewport-insets": [ratio * above, 0, ratio * below, ratio * before] });
  };
  const observer = new ResizeObserver(apply);
  for (const element of [photo, ...overlays]) observer.observe(element);
  host.on("size", apply);
}

/** Tints the areas that the brush protects, and draws the brush under the pointer. */
export function setUpBrushMarks(host: Host) {
  const canvas = byId("protected-areas", HTMLCanvasElement);
  const context = canvas.getContext("2d");
  let radius_px: number | undefined;
  let pointer: { x: number; y: number } | undefined;
  const draw = () => {
    canvas.hidden = radius_px === undefined;
    if (!context || radius_px === undefined) return;
    const { width, height } = host.canvas;
    // Clears it, too.
    Object.assign(canvas, { width, height });
    const circles = host.ask((studio) => studio.protectedOnCanvas()) ?? new Float32Array();
    drawStripes(context, circles);
    if (pointer) drawBrush(context, pointer, radius_px);
  };
  host.on("change", ({ brushPx }) => {
    radius_px = brushPx;
    draw();
  });
  host.on("frame", draw);
  host.canvas.addEventListener("pointermove", ({ offsetX, offsetY }) => {
    // These offsets need no layout, unlike the canvas's box.
    pointer = { x: offsetX, y: offsetY };
    draw();
  });
  host.canvas.addEventListener("pointerleave", () => {
    pointer = undefined;
    draw();
  });
}

/** @param circles x, y and radius of each, in px of the canvas */
function drawStripes(context: CanvasRenderingContext2D, circles: Float32Array) {
  const { width, height } = context.canvas;
  context.save();
  context.beginPath();
  for (let index = 0; index < circles.length; index += 3) {
    const [x = 0, y = 0, radius = 0] = circles.subarray(index, index + 3);
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.clip();
  context.fillStyle = "rgb(255 255 255 / 0.3)";
  context.fillRect(0, 0, width, height);
  context.lineWidth = 1.5;
  for (const [colour, shift] of STRIPES) {
    context.beginPath();
    for (let x = shift - height; x < width; x += STRIPE_PX) {
      context.moveTo(x, height);
      context.lineTo(x + height, 0);
    }
    context.strokeStyle = colour;
    context.stroke();
  }
  context.restore();
}

/** @param at CSS px, as the radius */
function drawBrush(context: CanvasRenderingContext2D, at: { x: number; y: number }, radius_px: number) {
  const ratio = devicePixelRatio;
  for (const [colour, width_px] of RINGS) {
    context.strokeStyle = colour;
    context.lineWidth = width_px * ratio;
    context.beginPath();
    context.arc(at.x * ratio, at.y * ratio, radius_px * ratio, 0, 2 * Math.PI);
    context.stroke();
  }
}
