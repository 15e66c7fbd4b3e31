import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

const CANDIDATES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** A WebGPU adapter in software and a canvas that presents, can be read, and shows in screenshots. */
const SOFTWARE_GPU = [
  "--enable-unsafe-webgpu",
  "--enable-features=Vulkan",
  "--use-vulkan=swiftshader",
  "--use-angle=swiftshader",
  "--use-webgpu-adapter=swiftshader",
  "--ignore-gpu-blocklist",
];

const QUIET = [
  "--no-sandbox",
  "--no-first-run",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** A camera that plays a film. */
const fakeCamera = (/** @type {string} */ film) => [
  "--use-fake-ui-for-media-stream",
  "--use-fake-device-for-media-stream",
  `--use-file-for-fake-video-capture=${film}`,
];

/**
 * Starts the system's Chromium without a window.
 *
 * @param {{ gpu?: "software" | "none", film?: string }} [options] `film`: a .y4m that a fake camera plays
 */
export function launch({ gpu = "software", film } = {}) {
  const args = [...QUIET, ...(gpu === "software" ? SOFTWARE_GPU : ["--disable-gpu", "--disable-features=WebGPU"]), ...(film ? fakeCamera(film) : [])];
  return chromium.launch({ executablePath: executable(), headless: true, args });
}

function executable() {
  const found = [process.env.ROSTO_BROWSER, ...CANDIDATES].find((path) => path && existsSync(path));
  if (!found) throw new Error("no Chromium here: run `cargo xtask setup`, or name one in ROSTO_BROWSER");
  return found;
}
