import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { Builder } from "selenium-webdriver";
import logInspector from "selenium-webdriver/bidi/logInspector.js";
import { findInPath } from "selenium-webdriver/io/index.js";
import { DriverService } from "selenium-webdriver/remote/index.js";

/** @typedef {Awaited<ReturnType<typeof start>>} Browser */

const SCREEN = "1280x900x24";
const START_MS = 15_000;
const SCRIPT_MS = 120_000;

/** Driver and capabilities of each engine; downloads are saved without a prompt. */
export const ENGINES = {
  chromium: { driver: () => process.env.CHROMEDRIVER ?? find("chromedriver"), capabilities: chromium },
  firefox: { driver: () => find("geckodriver"), capabilities: firefox },
  webkit: { driver: () => find("WebKitWebDriver"), capabilities: () => ({ browserName: "MiniBrowser" }) },
};

/** Without WebGPU. @param {string} downloads */
function chromium(downloads) {
  const binary = process.env.ROSTO_BROWSER ?? find("chromium", "chromium-browser", "google-chrome");
  const args = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--ignore-gpu-blocklist", "--disable-features=WebGPU"];
  const options = { binary, args, prefs: { "download.default_directory": downloads } };
  return { browserName: "chrome", webSocketUrl: true, "goog:chromeOptions": options };
}

/** @param {string} downloads */
function firefox(downloads) {
  const saved = { "browser.download.folderList": 2, "browser.download.dir": downloads, "browser.download.alwaysOpenPanel": false };
  const options = { binary: find("firefox-esr", "firefox"), prefs: { ...saved, "webgl.force-enabled": true } };
  return { browserName: "firefox", webSocketUrl: true, "moz:firefoxOptions": options };
}

/**
 * Starts a browser in a temporary home folder. Its `errors` are uncaught errors and console errors.
 *
 * @param {keyof typeof ENGINES} name
 * @param {NodeJS.ProcessEnv} env
 */
export async function start(name, env) {
  const { driver: program, capabilities } = ENGINES[name];
  const home = await mkdtemp(path.join(tmpdir(), `rosto-${name}-`));
  const downloads = path.join(home, "downloads");
  await mkdir(downloads);
  // GLib reads the download folder from this file.
  await writeFile(path.join(home, "user-dirs.dirs"), `XDG_DOWNLOAD_DIR="${downloads}"\n`);
  const folders = { HOME: home, XDG_CONFIG_HOME: home, XDG_CACHE_HOME: home, XDG_DATA_HOME: home };
  const service = new DriverService.Builder(program()).setLoopback(true).setEnvironment({ ...env, ...folders }).build();
  /** @type {import("selenium-webdriver").WebDriver | undefined} */
  let driver;
  const close = async () => {
    await driver?.quit().catch(() => {});
    await service.kill();
    // The browser's processes may still write for a moment.
    await rm(home, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  };
  try {
    driver = await new Builder().usingServer(await service.start()).withCapabilities(capabilities(downloads)).build();
    await driver.manage().setTimeouts({ script: SCRIPT_MS });
    await driver.manage().window().setRect({ x: 0, y: 0, width: 1024, height: 720 });
    const actual = await driver.getCapabilities();
    const version = `${actual.getBrowserName()} ${actual.getBrowserVersion()}`;
    /** @type {string[]} */
    const reported = [];
    // WebKit's driver does not speak WebDriver BiDi.
    if (actual.get("webSocketUrl")) {
      const inspector = await logInspector(driver);
      await inspector.onLog(({ level, text }) => level === "error" && reported.push(text));
    }
    const errors = async () => [...reported, ...(await driver.executeScript("return JSON.parse(sessionStorage.errors ?? '[]')"))];
    return { driver, name, version, downloads, errors, close };
  } catch (error) {
    await close();
    throw error;
  }
}

/** Makes a page that has just loaded record its errors. @param {import("selenium-webdriver").WebDriver} driver */
export function noteErrors(driver) {
  return driver.executeScript(() => {
    const note = (...words) => {
      sessionStorage.errors = JSON.stringify([...JSON.parse(sessionStorage.errors ?? "[]"), words.join(" ")]);
    };
    addEventListener("error", ({ message, error }) => note(message, error?.stack));
    addEventListener("unhandledrejection", ({ reason }) => note(reason, reason?.stack));
    const { error } = console;
    console.error = (...words) => {
      note(...words);
      error(...words);
    };
  });
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
  const found = names.map((name) => findInPath(name)).find(Boolean);
  if (!found) throw new Error(`no ${names.join(" or ")} on this machine; \`cargo xtask setup\` installs it`);
  return found;
}
