// The scenarios' operations, with Puppeteer for Chromium and Firefox, and with Selenium for WebKit.
import { setTimeout as sleep } from "node:timers/promises";
import puppeteer, { TargetCloseError } from "puppeteer-core";
import { Builder, By, error as errors, Key, Origin } from "selenium-webdriver";
import { DriverService } from "selenium-webdriver/remote/index.js";

/**
 * `evaluate` takes an expression or a function without parameters. `type` ends with a key. `drag` starts in the middle of an
 * element. `errors` are uncaught errors and console errors. `crashed` recognises a crash of the browser by its error.
 *
 * @typedef {Awaited<ReturnType<typeof launch>>} Driver
 */

export const WAIT_MS = 120_000;
/** Steps of a drag, in whole pixels. */
const STEPS = 10;
/** Human speed, so that no engine merges two moves. */
const STEP_MS = 16;

/** Starts Chromium or Firefox. @param {import("puppeteer-core").LaunchOptions} options */
export async function launch(options) {
  const browser = await puppeteer.launch({ ...options, defaultViewport: null });
  // Firefox focuses a new tab, but not its first one.
  const page = await browser.newPage();
  page.setDefaultTimeout(WAIT_MS);
  /** @type {string[]} */
  const reported = [];
  page.on("pageerror", (error) => reported.push(error instanceof Error ? error.stack : String(error)));
  // Reports of failed requests have no arguments.
  page.on("console", (message) => message.type() === "error" && message.args().length > 0 && reported.push(message.text()));
  return {
    version: (await browser.version()).replace("/", " "),
    goto: (url) => page.goto(url),
    reload: () => page.reload(),
    evaluate: (script) => page.evaluate(script),
    click: (selector) => page.click(selector),
    type: (text, key) => page.keyboard.type(text).then(() => page.keyboard.press(key)),
    chooseFile: async (selector, file) => (await page.$(selector)).uploadFile(file),
    drag: async (selector, by) => drag(page.mouse, await (await page.$(selector)).clickablePoint(), by),
    screenshot: () => page.screenshot(),
    errors: async () => reported,
    crashed: (error) => error instanceof TargetCloseError || !browser.connected,
    close: () => browser.close(),
  };
}

/** @param {import("puppeteer-core").Mouse} mouse @param {{ x: number, y: number }} from @param {{ x: number, y: number }} by */
async function drag(mouse, from, by) {
  await mouse.move(from.x, from.y);
  await mouse.down();
  for (let step = 1; step <= STEPS; step++) {
    await sleep(STEP_MS);
    await mouse.move(from.x + (by.x * step) / STEPS, from.y + (by.y * step) / STEPS);
  }
  await mouse.up();
}

/** Starts WebKitGTK's MiniBrowser. @param {string} program its driver @param {NodeJS.ProcessEnv} env @returns {Promise<Driver>} */
export async function launchWebKit(program, env) {
  // Selenium stops the driver when this process exits, if not before.
  const service = new DriverService.Builder(program).setLoopback(true).setEnvironment(env).build();
  const capabilities = { browserName: "MiniBrowser", timeouts: { script: WAIT_MS } };
  const driver = await new Builder().usingServer(await service.start()).withCapabilities(capabilities).build();
  await driver.manage().window().setRect({ x: 0, y: 0, width: 1024, height: 720 });
  const actual = await driver.getCapabilities();
  const find = (selector) => driver.findElement(By.css(selector));
  return {
    version: `${actual.getBrowserName()} ${actual.getBrowserVersion()}`,
    goto: (url) => driver.get(url).then(() => driver.executeScript(noteErrors)),
    reload: () => driver.navigate().refresh().then(() => driver.executeScript(noteErrors)),
    evaluate: (script) => driver.executeScript(typeof script === "string" ? `return ${script}` : script),
    click: (selector) => find(selector).click(),
    type: (text, key) => driver.actions().sendKeys(text, Key[key.toUpperCase()]).perform(),
    chooseFile: (selector, file) => find(selector).sendKeys(file),
    drag: async (selector, by) => {
      const actions = driver.actions().move({ origin: await find(selector), duration: 0 }).press();
      const move = { x: by.x / STEPS, y: by.y / STEPS, origin: Origin.POINTER, duration: STEP_MS };
      for (let step = 0; step < STEPS; step++) actions.move(move);
      await actions.release().perform();
    },
    screenshot: async () => Buffer.from(await driver.takeScreenshot(), "base64"),
    errors: () => driver.executeScript("return JSON.parse(sessionStorage.errors ?? '[]')"),
    crashed: (error) => error instanceof errors.NoSuchSessionError,
    close: () => driver.quit().catch(() => {}).then(() => service.kill()),
  };
}

/** Makes a page that has just loaded record its errors, which WebKit's driver does not report. */
function noteErrors() {
  const note = (...words) => {
    sessionStorage.errors = JSON.stringify([...JSON.parse(sessionStorage.errors ?? "[]"), words.join(" ")]);
  };
  addEventListener("error", ({ message, error }) => note(message, error?.stack));
  addEventListener("unhandledrejection", ({ reason }) => note(reason, reason?.stack));
  console.error = note;
}
