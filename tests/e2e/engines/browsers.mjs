import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync } from "node:fs";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { launch, launchWebKit } from "./drivers.mjs";

/** @typedef {Awaited<ReturnType<typeof start>>} Browser */

const SCREEN = "1280x900x24";
const START_MS = 15_000;

/** Start of each engine; downloads are saved without a prompt. */
export const ENGINES = { chromium, firefox, webkit: (env) => launchWebKit(find("WebKitWebDriver"), env) };

/** Without WebGPU. @param {NodeJS.ProcessEnv} env @param {string} downloadPath */
function chromium(env, downloadPath) {
  const executablePath = process.env.ROSTO_BROWSER ?? find("chromium", "chromium-browser", "google-chrome");
  const drawing = ["--use-angle=swiftshader", "--ignore-gpu-blocklist", "--disable-features=WebGPU"];
  const args = ["--no-sandbox", "--window-size=1024,720", ...drawing];
  return launch({ executablePath, args, env, downloadBehavior: { policy: "allow", downloadPath } });
}

/** @param {NodeJS.ProcessEnv} env @param {string} downloads */
function firefox(env, downloads) {
  const saved = { "browser.download.folderList": 2, "browser.download.dir": downloads, "browser.download.alwaysOpenPanel": false };
  const extraPrefsFirefox = { ...saved, "webgl.force-enabled": true };
  const [executablePath, args] = [find("firefox-esr", "firefox"), ["--width=1024", "--height=720"]];
  // Without a window, Firefox has no WebGL.
  return launch({ browser: "firefox", executablePath, args, env, headless: false, extraPrefsFirefox });
}

/** Starts a browser in a temporary home folder. @param {keyof typeof ENGINES} name @param {NodeJS.ProcessEnv} env */
export async function start(name, env) {
  const home = await mkdtemp(path.join(tmpdir(), `rosto-${name}-`));
  const downloads = path.join(home, "downloads");
  await mkdir(downloads);
  // GLib reads the download folder from this file.
  await writeFile(path.join(home, "user-dirs.dirs"), `XDG_DOWNLOAD_DIR="${downloads}"\n`);
  const folders = { HOME: home, XDG_CONFIG_HOME: home, XDG_CACHE_HOME: home, XDG_DATA_HOME: home };
  // The browser's processes may still write for a moment.
  const clean = () => rm(home, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  try {
    const driver = await ENGINES[name]({ ...env, ...folders }, downloads);
    return { ...driver, name, downloads, close: () => driver.close().finally(clean) };
  } catch (error) {
    await clean();
    throw error;
  }
}

/** Starts a virtual display, which Firefox and WebKit need for WebGL. */
export async function openDisplay() {
  const args = ["-displayfd", "3", "-screen", "0", SCREEN, "-nolisten", "tcp"];
  const server = spawn(find("Xvfb"), args, { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const [number] = await once(server.stdio[3], "data", { signal: AbortSignal.timeout(START_MS) });
  return {
    /** Environment for programs that use the display, with software rendering. */
    env: { ...process.env, DISPLAY: `:${String(number).trim()}`, WAYLAND_DISPLAY: "", LIBGL_ALWAYS_SOFTWARE: "1" },
    close: () => server.kill(),
  };
}

/** Path of the first of these programs found on PATH. @param {string[]} names */
function find(...names) {
  const folders = (process.env.PATH ?? "").split(path.delimiter);
  const found = names.flatMap((name) => folders.map((folder) => path.join(folder, name))).find(existsSync);
  if (!found) throw new Error(`no ${names.join(" or ")} on this machine; \`cargo xtask setup\` installs it`);
  return found;
}
