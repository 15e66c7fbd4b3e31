import { existsSync } from "node:fs";
import { chromium } from "@playwright/test";

const CANDIDATES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Software rendering; the canvas can be read and appears in screenshots. */
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

/** Skips compositing in software, which takes two thirds of the time. The WebGPU canvas is drawn but not shown. */
const UNSEEN = ["--disable-gpu-compositing"];

/** Name of this machine that is not a secure context over plain HTTP, unlike 127.0.0.1. */
export const INSECURE_HOST = "rosto.example";

const QUIET = [
  "--no-sandbox",
  "--no-first-run",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-gpu-process-crash-limit",
  `--host-resolver-rules=MAP ${INSECURE_HOST} 127.0.0.1`,
];

/**
 * Starts the system's Chromium without a window.
 *
 * @param {{ gpu?: keyof typeof GPUS, video?: string, seen?: boolean, keepsPages?: boolean }} [options] `video`: .y4m file for
 *   a fake camera; `seen`: screenshots show the 3D view; `keepsPages`: enables the back/forward cache
 */
export function launch({ gpu = "webgpu", video, seen = true, keepsPages = false } = {}) {
  const camera = ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${video}`];
  const args = [...QUIET, ...GPUS[gpu], ...(seen ? [] : UNSEEN), ...(video ? camera : [])];
  const ignoreDefaultArgs = keepsPages ? ["--disable-back-forward-cache"] : [];
  return chromium.launch({ executablePath: executable(), headless: true, args, ignoreDefaultArgs });
}

function executable() {
  const found = [process.env.ROSTO_BROWSER, ...CANDIDATES].find((path) => path && existsSync(path));
  if (!found) throw new Error("Chromium not found: run `cargo xtask setup`, or set ROSTO_BROWSER");
  return found;
}
