import { existsSync } from "node:fs";
import { chromium } from "@playwright/test";

const CANDIDATES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** What draws, in software: a canvas presents, can be read, and shows in screenshots. */
const GPUS = {
  webgpu: [
    "--enable-unsafe-webgpu",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
    "--use-webgpu-adapter=swiftshader",
    "--ignore-gpu-blocklist",
  ],
  webgl: ["--use-angle=swiftshader", "--ignore-gpu-blocklist", "--disable-features=WebGPU"],
  none: ["--disable-gpu", "--disable-3d-apis"],
};

/** A WebGPU canvas is drawn and never shown: putting the page together in software as well costs twice what the rest does. */
const UNSEEN = ["--disable-gpu-compositing"];

const QUIET = [
  "--no-sandbox",
  "--no-first-run",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-gpu-process-crash-limit",
];

/**
 * Starts the system's Chromium without a window.
 *
 * @param {{ gpu?: keyof typeof GPUS, film?: string, seen?: boolean, keepsPages?: boolean }} [options] `film`: a .y4m that a fake camera plays;
 *   `seen`: whether the 3D view shows in screenshots; `keepsPages`: whether pages that are left are kept for the way back
 */
export function launch({ gpu = "webgpu", video, seen = true, keepsPages = false } = {}) {
  const camera = ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${video}`];
  const args = [...QUIET, ...GPUS[gpu], ...(seen ? [] : UNSEEN), ...(video ? camera : [])];
  const ignoreDefaultArgs = keepsPages ? ["--disable-back-forward-cache"] : [];
  return chromium.launch({ executablePath: executable(), headless: true, args, ignoreDefaultArgs });
}

function executable() {
  const found = [process.env.ROSTO_BROWSER, ...CANDIDATES].find((path) => path && existsSync(path));
  if (!found) throw new Error("no Chromium here: run `cargo xtask setup`, or name one in ROSTO_BROWSER");
  return found;
}
