import type { Host } from "../viewport/host.ts";
import type { State } from "../../wasm/rosto-studio-web.js";

/** Radius of the sphere, and width of its SVG, in units of the SVG. */
const SPHERE = 40;
const WIDTH = 96;

const RADIAN_DEG = 180 / Math.PI;

/** Sets the direction of the light by dragging on a sphere. */
export function setUpLightSphere(host: Host) {
  const sphere = document.getElementById("light-sphere") as unknown as SVGSVGElement;
  const drag = ({ clientX, clientY }: PointerEvent) => {
    const { left, top, width, height } = sphere.getBoundingClientRect();
    const x = ((clientX - left) / width - 0.5) * (WIDTH / SPHERE);
    const y = (0.5 - (clientY - top) / height) * (WIDTH / SPHERE);
    const radius = Math.max(1, Math.hypot(x, y));
    const toViewer = Math.sqrt(Math.max(0, 1 - (x * x + y * y) / (radius * radius)));
    host.applyShown({ set: ["light.azimuth", Math.round(RADIAN_DEG * Math.atan2(x / radius, toViewer))] });
    host.applyShown({ set: ["light.elevation", Math.round(RADIAN_DEG * Math.asin(y / radius))] });
  };
  sphere.addEventListener("pointerdown", (event) => {
    sphere.setPointerCapture(event.pointerId);
    drag(event);
  });
  sphere.addEventListener("pointermove", (event) => sphere.hasPointerCapture(event.pointerId) && drag(event));
  const sun = sphere.querySelector("#light-sun");
  const show = ({ light }: State) => {
    const [azimuth, elevation] = [light.azimuthDeg / RADIAN_DEG, light.elevationDeg / RADIAN_DEG];
    sun?.setAttribute("cx", String(SPHERE * Math.sin(azimuth) * Math.cos(elevation)));
    sun?.setAttribute("cy", String(-SPHERE * Math.sin(elevation)));
    sun?.toggleAttribute("data-behind", Math.cos(azimuth) < 0);
  };
  host.on("change", show);
  // The light is not part of the document.
  host.on("panel", (widgets) => widgets.some(({ id }) => id.startsWith("light")) && host.read(show));
}
