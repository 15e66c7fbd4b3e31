import type { Host } from "../viewport/host.ts";

/** Radius of the sphere, and width of its SVG, in units of the SVG. */
const SPHERE = 40;
const WIDTH = 96;

/** Sets the direction of the light by dragging on a sphere. */
export function setUpLightSphere(host: Host) {
  const sphere = document.getElementById("light-sphere") as unknown as SVGSVGElement;
  const drag = (event: PointerEvent) => {
    const { left, top, width, height } = sphere.getBoundingClientRect();
    const x = ((event.clientX - left) / width - 0.5) * (WIDTH / SPHERE);
    const y = (0.5 - (event.clientY - top) / height) * (WIDTH / SPHERE);
    const radius = Math.max(1, Math.hypot(x, y));
    const toViewer = Math.sqrt(Math.max(0, 1 - (x * x + y * y) / (radius * radius)));
    host.applyShown({ set: ["light.azimuth", degrees(Math.atan2(x / radius, toViewer))] });
    host.applyShown({ set: ["light.elevation", degrees(Math.asin(y / radius))] });
  };
  sphere.addEventListener("pointerdown", (event) => {
    sphere.setPointerCapture(event.pointerId);
    drag(event);
  });
  sphere.addEventListener("pointermove", (event) => {
    if (sphere.hasPointerCapture(event.pointerId)) drag(event);
  });
  host.onPanel(() => host.read(({ light }) => showSun(light.azimuthDeg, light.elevationDeg)));
}

function showSun(azimuth_deg: number, elevation_deg: number) {
  const sun = document.getElementById("light-sun");
  const [azimuth, elevation] = [radians(azimuth_deg), radians(elevation_deg)];
  sun?.setAttribute("cx", String(SPHERE * Math.sin(azimuth) * Math.cos(elevation)));
  sun?.setAttribute("cy", String(-SPHERE * Math.sin(elevation)));
  sun?.toggleAttribute("data-behind", Math.cos(azimuth) < 0);
}

function degrees(angle: number) {
  return Math.round((angle * 180) / Math.PI);
}

function radians(angle_deg: number) {
  return (angle_deg * Math.PI) / 180;
}
