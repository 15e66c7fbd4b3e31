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

const FAKE_CAMERA = ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream"];

/**
 * Starts the system's Chromium without a window.
 *
 * @param {{ gpu?: "software" | "none", camera?: boolean }} [options]
 */
export function launch({ gpu = "software", camera = false } = {}) {
  const args = [...QUIET, ...(gpu === "software" ? SOFTWARE_GPU : ["--disable-gpu", "--disable-features=WebGPU"]), ...(camera ? FAKE_CAMERA : [])];
  return chromium.launch({ executablePath: executable(), headless: true, args });
}

function executable() {
  const found = [process.env.ROSTO_BROWSER, ...CANDIDATES].find((path) => path && existsSync(path));
  if (!found) throw new Error("no Chromium here: run `cargo xtask setup`, or name one in ROSTO_BROWSER");
  return found;
}
