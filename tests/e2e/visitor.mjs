import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { untilSaved } from "./storage.mjs";

export const SAMPLE = path.resolve(import.meta.dirname, "../../web/assets/sample.png");

/** Prefix of the console line that reports a policy violation. */
const VIOLATION = "policy violation:";

/** Maximum number of screenshots until the 3D view is still. */
const MAX_SHOTS = 20;

/** Drives one page and reads what it shows. */
export class Visitor {
  /** Uncaught errors and policy violations. */
  errors = [];
  /** Console output of the page's own code. */
  consoleLines = [];
  /** Messages of the browser itself, which differ between versions; only for the log of a failed test. */
  browserLines = [];
  /** Whether screenshots show the 3D view. */
  showsView = true;
  /** URLs of all requests so far. @type {string[]} */
  requests = [];
  /** Other tabs of the same browser. @type {Visitor[]} */
  tabs = [];
  /** A project of the sample portrait, for {@link openFace}. @type {Uint8Array | undefined} */
  project;

  /**
   * @typedef {object} Visit
   * @property {(context: import("@playwright/test").BrowserContext) => unknown} [before] runs before the page opens
   * @property {((...values: any[]) => unknown | string)[]} [scripts] run in the page before its own
   * @property {boolean} [hasClock] installs a fake clock
   * @property {boolean} [expert] shows technical controls
   * @property {"load" | "commit"} [waitUntil] when the visit begins
   *
   * @param {import("@playwright/test").Browser} browser
   * @param {string} url
   * @param {Visit & import("@playwright/test").BrowserContextOptions} [options]
   */
  static async open(browser, url, { before, scripts = [], hasClock = false, expert = false, waitUntil = "load", ...options } = {}) {
    const context = await browser.newContext({
      viewport: { width: 1024, height: 640 },
      locale: "en-GB",
      reducedMotion: "reduce",
      serviceWorkers: "block",
      ...options,
    });
    if (hasClock) await context.clock.install();
    if (expert) await context.addInitScript(rememberExpert);
    for (const script of scripts) await context.addInitScript(script);
    await before?.(context);
    await context.addInitScript(reportViolations, VIOLATION);
    const visitor = new Visitor(await context.newPage());
    visitor.address = url;
    await visitor.page.goto(url, { waitUntil });
    return visitor;
  }

  /** @param {import("@playwright/test").Page} page */
  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(60_000);
    page.context().on("request", (request) => this.requests.push(request.url()));
    // Answers every file dialog with the sample. A dialog that opens before Playwright listens would be lost.
    page.on("filechooser", (chooser) => chooser.setFiles(SAMPLE).catch(() => {}));
    page.on("pageerror", (error) => this.errors.push(error));
    page.on("console", (message) => {
      // Only console calls of the page have arguments.
      const isOfPage = message.args().length > 0;
      (isOfPage ? this.consoleLines : this.browserLines).push(`${message.type()}: ${message.text()}`);
      if (isOfPage && message.text().startsWith(VIOLATION)) this.errors.push(message.text());
    });
  }

  assertNoErrors() {
    assert.deepEqual([this, ...this.tabs].flatMap(({ errors }) => errors), []);
  }

  async leave() {
    await this.page.context().close();
  }

  /** Opens the page in another tab. @param {() => void} [script] runs in the page before its own */
  async openTab(script) {
    const other = new Visitor(await this.page.context().newPage());
    Object.assign(other, { showsView: this.showsView, project: this.project, address: this.address, tabs: this.tabs });
    this.tabs.push(other);
    if (script) await other.page.addInitScript(script);
    await other.page.goto(this.address);
    await other.untilLoaded();
    return other;
  }

  /** Waits until the page has loaded everything, after which it makes no request. */
  async untilLoaded() {
    await this.page.waitForSelector("#privacy-count[data-requests='0']", { state: "attached" });
  }

  /** Waits for the language list, which shows that the page's scripts have run. */
  async untilInteractive() {
    await this.page.waitForSelector("#language option", { state: "attached" });
  }

  /** Drops a file on the page. @param {Uint8Array} bytes @param {string} name */
  async drop(bytes, name) {
    await this.untilInteractive();
    await this.page.locator("body").drop({ files: { name, mimeType: "", buffer: Buffer.from(bytes) } });
  }

  async dropSample(name = "portrait.png") {
    await this.drop(await readFile(SAMPLE), name);
    await this.untilFace();
  }

  /** Opens the sample portrait from a project, without face detection. @param {string} [name] file name */
  async openFace(name = "portrait") {
    await this.drop(this.project, `${name}.rosto`);
    await this.untilFace();
  }

  /** Waits until the work is saved, reloads the page and resumes. */
  async reloadAndResume() {
    await untilSaved(this.page);
    await this.page.reload();
    await this.resume();
  }

  /** Resumes the work that the empty page offers. */
  async resume() {
    await this.page.bringToFront();
    await this.page.click("#continue");
    await this.untilFace();
  }

  /** Mesh and history. */
  async work() {
    await this.page.bringToFront();
    return { mesh: await this.meshJson("mm"), history: await this.history() };
  }

  /** Chooses a language, even if the list is hidden. @param {string} language */
  async setLanguage(language) {
    await this.page.selectOption("#language", language, { force: true });
    await this.page.waitForSelector(`html[lang^="${language}"]`, { state: "attached" });
    await this.frames(2);
  }

  /** Waits until a face is open and has its whole-face texture. */
  async untilFace() {
    await this.page.waitForSelector("body[data-state='face']");
    await this.page.waitForSelector("#progress", { state: "hidden" });
    await this.page.waitForSelector("body:not([data-texture])");
    await this.frames(3);
  }

  /** Waits for `count` animation frames. @param {number} count */
  async frames(count) {
    await this.page.evaluate(async (count) => {
      for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
    }, count);
  }

  /** Shows a section of the panel: selects its tab and opens its folds. */
  unfold(id) {
    return this.reveal(`#${id}`);
  }

  /** Shows an element of the panel: selects its tab and opens its folds. @param {string} selector */
  async reveal(selector) {
    if ((await this.page.locator(`[data-expert]:is(${selector}, :has(${selector}))`).count()) > 0) await this.enableExpert();
    const tab = await this.page.locator(`#sections > [data-tab]:is(${selector}, :has(${selector}))`).getAttribute("data-tab");
    const button = this.page.locator(`[data-tab-name="${tab}"]:not([aria-selected="true"])`);
    if (await button.isVisible()) await button.click();
    await this.#choosePart(selector);
    const folded = this.page.locator(`details:not([open]):is(${selector}, :has(${selector})) > summary`);
    while ((await folded.count()) > 0) await folded.first().click();
  }

  /** Chooses the part of the face that has an element; in small windows, also expressions and points. @param {string} selector */
  async #choosePart(selector) {
    const parts = await this.page.locator("#shape input").evaluateAll((inputs) => inputs.map(({ value }) => value));
    const holders = { face: ":is(#shape-face, #symmetry)", expressions: "#section-expressions", point: "#section-landmark" };
    for (const part of parts) {
      const holder = holders[part] ?? `#shape-${part}`;
      const isThere = await this.page.locator(`${holder}:is(${selector}, :has(${selector}))`).count();
      if (isThere && !(await this.page.locator(holder).first().isVisible())) await this.page.check(`#shape input[value="${part}"]`, { force: true });
    }
  }

  /** Shows technical controls and point numbers. */
  async enableExpert() {
    await this.page.locator("#expert").setChecked(true, { force: true });
  }

  /** Finds a landmark by name or number. @param {string} text */
  async findLandmark(text) {
    await this.selectBy("landmark");
    await this.page.fill("#landmark-search", text);
    await this.page.press("#landmark-search", "Enter");
  }

  /** Selects a region. @param {string} region id such as "left-brow" */
  async selectRegion(region) {
    await this.selectBy("region");
    await this.page.selectOption("#region", region);
    await this.frames(3);
  }

  /** Chooses what a click or a drag selects. @param {"region" | "landmark" | "point"} mode */
  async selectBy(mode) {
    await this.unfold("section-landmark");
    await this.page.check(`input[name='selection'][value='${mode}']`, { force: true });
  }

  /** Position of the tagged landmark, in CSS px of the window. */
  async tagPosition() {
    await this.frames(3);
    const stage = await this.page.locator("#stage").boundingBox();
    const [x = 0, y = 0] = ((await this.page.getAttribute("#landmark-tag", "data-place")) ?? "").split(" ").map(Number.parseFloat);
    return { x: stage.x + x, y: stage.y + y };
  }

  /**
   * Position of the selection in the window. The pointer leaves the view, because the tag shows a hovered point first.
   */
  async selectionPosition() {
    await this.page.mouse.move(1, 1);
    return this.tagPosition();
  }

  /**
   * Position of a landmark in the window. Selects the landmark and clears the selection again.
   *
   * @param {number} landmark
   */
  async landmarkPosition(landmark) {
    await this.findLandmark(String(landmark));
    const place = await this.selectionPosition();
    await this.page.focus("#viewport");
    await this.page.keyboard.press("Escape");
    return place;
  }

  /** Converts a position in the window to pixels of {@link view}. @param {{ x: number, y: number }} place */
  async toViewPixels({ x, y }) {
    const box = await this.page.locator("#viewport").boundingBox();
    const ratio = await this.page.evaluate(() => devicePixelRatio);
    return { x: (x - box.x) * ratio, y: (y - box.y) * ratio };
  }

  /** A point of the window where the 3D view does not show the face. */
  async emptyPoint() {
    const view = await this.page.locator("#viewport").boundingBox();
    return { x: view.x + 20, y: view.y + view.height / 2 };
  }

  /** Cursor over the 3D view. */
  cursor() {
    return this.page.locator("#viewport").evaluate((canvas) => getComputedStyle(canvas).cursor);
  }

  /**
   * Presses the mouse at a position and moves it.
   *
   * @param {{ x: number, y: number }} from
   * @param {{ x: number, y: number }} by
   */
  async grab(from, by) {
    await this.page.mouse.move(from.x, from.y);
    await this.page.mouse.down();
    await this.page.mouse.move(from.x + by.x, from.y + by.y, { steps: 6 });
  }

  /**
   * Drags the mouse: {@link grab} and release.
   *
   * @param {{ x: number, y: number }} from
   * @param {{ x: number, y: number }} by
   */
  async drag(from, by) {
    await this.grab(from, by);
    await this.page.mouse.up();
    await this.frames(3);
  }

  /** Chooses the preset of edits. @param {"sculpt" | "paper"} preset */
  async choosePreset(preset) {
    await this.reveal("#preset");
    await this.page.check(`input[name="preset"][value="${preset}"]`, { force: true });
  }

  /** Enters an offset into the number field of an axis. @param {"x" | "y" | "z"} axis @param {number} offset_mm */
  async setOffset(axis, offset_mm) {
    await this.unfold("section-landmark");
    await this.#enter(`#landmark-offset [data-axis="${axis}"]`, offset_mm);
  }

  /**
   * Moves a landmark along an axis.
   *
   * @param {string} landmark
   * @param {"x" | "y" | "z"} axis
   * @param {number} offset_mm
   */
  async move(landmark, axis, offset_mm) {
    await this.findLandmark(landmark);
    await this.setOffset(axis, offset_mm);
  }

  /**
   * Sets a proportion slider by its number field.
   *
   * @param {string} slider id such as "nose-width"
   * @param {number} amount_mm
   */
  async setSlider(slider, amount_mm) {
    await this.unfold(`slider-${slider}`);
    await this.#enter(`#slider-${slider}`, amount_mm);
  }

  /** @param {string} slider @param {number} amount_mm */
  async #enter(slider, amount_mm) {
    const field = this.page.locator(`${slider} .number-field`);
    await field.fill(String(amount_mm));
    await field.press("Tab");
    await this.frames(3);
  }

  /** @param {string} slider */
  async sliderValue(slider) {
    return Number((await this.page.inputValue(`#slider-${slider} .number-field`)).replace(",", "."));
  }

  /** Names of the listed edits, newest first. */
  async history() {
    return this.page.locator("#history .check-label").allTextContents();
  }

  /** Number of the selected landmark. */
  async selectedLandmark() {
    await this.enableExpert();
    return Number((await this.page.inputValue("#landmark-search")).match(/\d+$/)?.[0]);
  }

  /** Number of the selected point of a dense mesh. */
  async selectedPoint() {
    return Number((await this.page.inputValue("#landmark-search")).match(/[\d,]+/)?.[0].replaceAll(",", ""));
  }

  /** Anchors of the edit, as the panel lists them. */
  async anchors() {
    const text = (await this.page.textContent("#landmark-anchors")) ?? "";
    return (text.split(": ")[1] ?? "").split(", ").filter(Boolean).map(Number);
  }

  /** @param {"mm" | "image"} units */
  async meshJson(units) {
    await this.unfold("section-export");
    // Only visible in Expert mode, so it is set by script.
    await this.page.locator(`input[name="export-units"][value="${units}"]`).evaluate((input) => input.click());
    const [download] = await Promise.all([
      this.page.waitForEvent("download"),
      this.page.dispatchEvent("[data-action='download-json']", "click"),
    ]);
    return JSON.parse(await readFile(await download.path(), "utf8"));
  }

  /** Bytes of the file that a button saves. @param {string} action */
  async download(action) {
    return (await this.save(action)).bytes;
  }

  /** Bytes and name of the file that a button saves. @param {string} action */
  async save(action) {
    await this.showButton(action);
    const [download] = await Promise.all([
      this.page.waitForEvent("download"),
      this.page.click(`#panel [data-action="${action}"]`),
    ]);
    return { bytes: await readFile(await download.path()), name: download.suggestedFilename() };
  }

  /** Shows the button that saves a file, in the panel or in the menu. @param {string} action */
  async showButton(action) {
    if (await this.page.locator(`#save-popover [data-action="${action}"]`).count()) await this.openSaveMenu();
    else await this.reveal(`[data-action="${action}"]`);
  }

  /** Opens the menu of everything that can be saved. */
  async openSaveMenu() {
    if (!(await this.page.isVisible("#save-popover"))) await this.page.click("#save-more");
  }

  /** {@link view}, once the marks at the selection have faded, which they do a second after their last use. */
  async viewWithoutMarks() {
    await this.page.waitForFunction(() => {
      const tag = document.getElementById("landmark-tag");
      return tag.hidden || tag.style.opacity === "0";
    });
    return this.view();
  }

  /** Pixels of the 3D view once it is still, without the elements over it. */
  async view() {
    assert.ok(this.showsView, 'this browser cannot screenshot the 3D view: tag the test with @eyes');
    await this.#showFloating("hidden");
    let shot = await this.#shot();
    for (let tries = 0; tries < MAX_SHOTS; tries += 1) {
      const next = await this.#shot();
      if (next.equals(shot)) break;
      shot = next;
    }
    await this.#showFloating("");
    return PNG.sync.read(shot);
  }

  async #shot() {
    await this.frames(3);
    return this.page.locator("#viewport").screenshot();
  }

  /** @param {"" | "hidden"} visibility of the elements over the 3D view */
  #showFloating(visibility) {
    return this.page.evaluate((visibility) => {
      for (const element of document.querySelectorAll(".stage > :not(.viewport)")) element.style.visibility = visibility;
    }, visibility);
  }

  /** Waits for a notice; returns its code and text. */
  async notice() {
    const notice = this.page.locator("#notice");
    await notice.waitFor();
    const code = await notice.getAttribute("data-code");
    return { code, text: (await notice.innerText()).trim() };
  }
}

/** Runs in the page. @param {string} violation */
function reportViolations(violation) {
  addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI, sample }) =>
    console.error(`${violation} ${violatedDirective} ${blockedURI} ${sample}`));
}

/** Runs in the page, and in an empty one without storage. */
function rememberExpert() {
  try {
    localStorage.setItem("rosto.expert", "on");
  } catch {
    // Runs again in the page itself.
  }
}
