import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { Builder } from "selenium-webdriver";
import logInspector from "selenium-webdriver/bidi/logInspector.js";
import { findInPath } from "selenium-webdriver/io/index.js";
import { DriverService } from "selenium-webdriver/remote/index.js";

/**
 * @typedef {object} Browser
 * @property {import("selenium-webdriver").WebDriver} driver
 * @property {string} name of the engine
 * @property {string} version with the browser's name
 * @property {string} downloads the folder that files are downloaded to
 * @property {() => Promise<Buffer>} screenshot PNG
 * @property {() => Promise<string[]>} errors uncaught errors of the page, and errors on its console
 * @property {() => Promise<void>} close
 */

const SCREEN = "1280x900x24";
const START_MS = 15_000;
const SCRIPT_MS = 120_000;

/** Each engine's driver, and the capabilities of a browser that saves its downloads unasked. */
export const ENGINES = {
  chromium: { driver: "chromedriver", capabilities: chromium },
  firefox: { driver: "geckodriver", capabilities: firefox },
  webkit: { driver: "WebKitWebDriver", capabilities: () => ({ browserName: "MiniBrowser" }) },
};

/** Without WebGPU. @param {string} downloads */
function chromium(downloads) {
  return {
    browserName: "chrome",
    webSocketUrl: true,
    "goog:chromeOptions": {
      binary: process.env.ROSTO_BROWSER ?? find("chromium", "chromium-browser", "google-chrome"),
      args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--ignore-gpu-blocklist", "--disable-features=WebGPU"],
      prefs: { "download.default_directory": downloads },
    },
  };
}

/** @param {string} downloads */
function firefox(downloads) {
  const saved = { "browser.download.folderList": 2, "browser.download.dir": downloads, "browser.download.alwaysOpenPanel": false };
  const prefs = { ...saved, "webgl.force-enabled": true };
  return { browserName: "firefox", webSocketUrl: true, "moz:firefoxOptions": { binary: find("firefox-esr", "firefox"), prefs } };
}

/**
 * Starts a browser in a home folder of its own, which goes with it.
 *
 * @param {keyof typeof ENGINES} name
 * @param {NodeJS.ProcessEnv} env
 * @returns {Promise<Browser>}
 */
export async function start(name, env) {
  const { driver: program, capabilities } = ENGINES[name];
  const home = await mkdtemp(path.join(tmpdir(), `rosto-${name}-`));
  const downloads = await downloadsIn(home);
  const folders = { HOME: home, XDG_CONFIG_HOME: path.join(home, "config"), XDG_CACHE_HOME: path.join(home, "cache"), XDG_DATA_HOME: path.join(home, "data") };
  const executable = (name === "chromium" && process.env.CHROMEDRIVER) || find(program);
  const service = new DriverService.Builder(executable).setLoopback(true).setEnvironment({ ...env, ...folders }).build();
  /** @type {import("selenium-webdriver").WebDriver | undefined} */
  let driver;
  const close = async () => {
    await driver?.quit().catch(() => {});
    await service.kill();
    // Its processes end a little later and still write what they keep.
    await rm(home, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  };
  try {
    driver = await new Builder().usingServer(await service.start()).withCapabilities(capabilities(downloads)).build();
    await driver.manage().setTimeouts({ script: SCRIPT_MS });
    await driver.manage().window().setRect({ x: 0, y: 0, width: 1024, height: 720 });
    const actual = await driver.getCapabilities();
    const version = `${actual.getBrowserName()} ${actual.getBrowserVersion()}`;
    const errors = actual.get("webSocketUrl") ? await reported(driver) : () => noted(driver);
    return { driver, name, version, downloads, screenshot: () => screenshotOf(driver), errors, close };
  } catch (error) {
    await close();
    throw error;
  }
}

/** A folder that GLib finds as the one for downloads. @param {string} home */
async function downloadsIn(home) {
  const downloads = path.join(home, "downloads");
  await mkdir(downloads);
  await mkdir(path.join(home, "config"));
  await writeFile(path.join(home, "config/user-dirs.dirs"), `XDG_DOWNLOAD_DIR="${downloads}"\n`);
  return downloads;
}

/** chromedriver's own screenshots have a limit of 10 s, which is too short for a busy machine without a GPU. @param {any} driver */
async function screenshotOf(driver) {
  const isChromium = "sendAndGetDevToolsCommand" in driver;
  const png = isChromium ? (await driver.sendAndGetDevToolsCommand("Page.captureScreenshot", {})).data : await driver.takeScreenshot();
  return Buffer.from(png, "base64");
}

/** The page's errors as WebDriver BiDi reports them. @param {import("selenium-webdriver").WebDriver} driver */
async function reported(driver) {
  /** @type {string[]} */
  const errors = [];
  const inspector = await logInspector(driver);
  await inspector.onLog(({ level, text }) => level === "error" && errors.push(text));
  return async () => errors;
}

/** What {@link noteErrors} noted: WebKit's driver does not speak BiDi. @param {import("selenium-webdriver").WebDriver} driver @returns {Promise<string[]>} */
function noted(driver) {
  return driver.executeScript("return JSON.parse(sessionStorage.getItem('errors') ?? '[]')");
}

/** Has a page that has just loaded note its errors. @param {import("selenium-webdriver").WebDriver} driver */
export function noteErrors(driver) {
  return driver.executeScript(() => {
    const note = (...words) => {
      const noted = JSON.parse(sessionStorage.getItem("errors") ?? "[]");
      sessionStorage.setItem("errors", JSON.stringify([...noted, words.join(" ")]));
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

/** A screen that nobody sees: Firefox and WebKit have no WebGL without one. */
export async function openDisplay() {
  const server = spawn(find("Xvfb"), ["-displayfd", "3", "-screen", "0", SCREEN, "-nolisten", "tcp"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const [number] = await once(server.stdio[3], "data", { signal: AbortSignal.timeout(START_MS) });
  return {
    /** For programs that draw on it, in software. */
    env: { ...process.env, DISPLAY: `:${String(number).trim()}`, WAYLAND_DISPLAY: "", LIBGL_ALWAYS_SOFTWARE: "1" },
    close: () => server.kill(),
  };
}

/** A program on PATH, by the first of its names that is there. @param {string[]} names */
function find(...names) {
  const found = names.map((name) => findInPath(name)).find(Boolean);
  if (!found) throw new Error(`no ${names.join(" or ")} on this machine; \`cargo xtask setup\` installs it`);
  return found;
}
