import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { untilKept } from "./kept.mjs";

export const SAMPLE = path.resolve(import.meta.dirname, "../../web/assets/sample.png");

/** Starts the line that a page writes when it did what its own policy forbids. */
const VIOLATION = "policy violation:";

/** How often the 3D view is looked at, at most, until it has come to rest. */
const MOST_SHOTS = 20;

/** Someone at the page: what they do, and what they see. */
export class Visitor {
  /** Errors the page let through, and what its policy had to refuse. */
  broken = [];
  /** Console output of the page's own code. */
  said = [];
  /** Messages of the browser itself, which differ between versions: for the log of a failed test only. */
  browserSaid = [];
  /** Whether screenshots show the 3D view. */
  sees = true;
  /** Addresses of all requests so far. @type {string[]} */
  requests = [];
  /** Other tabs of the same browser. @type {Visitor[]} */
  tabs = [];
  /** A project of the sample portrait, for {@link openFace}. @type {Uint8Array | undefined} */
  project;

  /**
   * @typedef {object} Visit
   * @property {(context: import("@playwright/test").BrowserContext) => unknown} [before] what is done before the page opens
   * @property {((...values: any[]) => unknown | string)[]} [scripts] run in the page before its own
   * @property {boolean} [hasClock] whether the page's time can be moved on
   * @property {boolean} [expert] whether technical controls are shown
   *
   * @param {import("@playwright/test").Browser} browser
   * @param {string} url
   * @param {Visit & import("@playwright/test").BrowserContextOptions} [options]
   */
  static async arrive(browser, url, { before, scripts = [], hasClock = false, expert = false, ...options } = {}) {
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
    await visitor.page.goto(url);
    return visitor;
  }

  /** @param {import("@playwright/test").Page} page */
  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(60_000);
    page.context().on("request", (request) => this.requests.push(request.url()));
    // Every file dialog is answered with the sample, unless its page is left. One that opens before Playwright listens would be lost.
    page.on("filechooser", (chooser) => chooser.setFiles(SAMPLE).catch(() => {}));
    page.on("pageerror", (error) => this.broken.push(error));
    page.on("console", (message) => {
      // Only calls of the console have arguments.
      const isOfPage = message.args().length > 0;
      (isOfPage ? this.said : this.browserSaid).push(`${message.type()}: ${message.text()}`);
      if (isOfPage && message.text().startsWith(VIOLATION)) this.broken.push(message.text());
    });
  }

  checkNothingBroke() {
    assert.deepEqual([this, ...this.tabs].flatMap(({ broken }) => broken), []);
  }

  async leave() {
    await this.page.context().close();
  }

  /** Opens the page in another tab. @param {() => void} [script] runs in the page before its own */
  async anotherTab(script) {
    const other = new Visitor(await this.page.context().newPage());
    Object.assign(other, { sees: this.sees, project: this.project, address: this.address, tabs: this.tabs });
    this.tabs.push(other);
    if (script) await other.page.addInitScript(script);
    await other.page.goto(this.address);
    await other.untilLoaded();
    return other;
  }

  /** Waits until the page has all its parts, after which it makes no request. */
  async untilLoaded() {
    await this.page.waitForSelector("#privacy-count[data-requests='0']", { state: "attached" });
  }

  /** Waits until there are languages to choose from: the page's own scripts have run, and answer. Only a script is sooner. */
  async untilItAnswers() {
    await this.page.waitForSelector("#language option", { state: "attached" });
  }

  /** Drops a file anywhere on the page. @param {Uint8Array} bytes @param {string} name */
  async drop(bytes, name) {
    await this.untilItAnswers();
    await this.page.locator("body").drop({ files: { name, mimeType: "", buffer: Buffer.from(bytes) } });
  }

  async dropSample(name = "portrait.png") {
    await this.drop(await readFile(SAMPLE), name);
    await this.untilFace();
  }

  /** Opens the sample portrait without a search for its face. @param {string} [name] of its file */
  async openFace(name = "portrait") {
    await this.drop(this.project, `${name}.rosto`);
    await this.untilFace();
  }

  /** Reloads the page once its work is kept, and resumes it. */
  async comeBack() {
    await untilKept(this.page);
    await this.page.reload();
    await this.resume();
  }

  /** Resumes the work that the empty page offers. */
  async resume() {
    await this.page.bringToFront();
    await this.page.click("#continue");
    await this.untilFace();
  }

  /** The mesh, and what was done to it. */
  async work() {
    await this.page.bringToFront();
    return { mesh: await this.meshJson("mm"), history: await this.history() };
  }

  /** Has the page in another language, as by its list of them, which may be out of sight. @param {string} language */
  async speak(language) {
    await this.page.selectOption("#language", language, { force: true });
    await this.page.waitForSelector(`html[lang^="${language}"]`, { state: "attached" });
    await this.frames(2);
  }

  /** Waits until a face is on the canvas, all round. */
  async untilFace() {
    await this.page.waitForSelector("body[data-state='face']");
    await this.page.waitForSelector("#progress", { state: "hidden" });
    await this.page.waitForSelector("body:not([data-texture])");
    await this.frames(3);
  }

  /** Waits for so many frames to be drawn. @param {number} count */
  async frames(count) {
    await this.page.evaluate(async (count) => {
      for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
    }, count);
  }

  /** Shows a section of the panel, whichever tab or folds hide it. */
  unfold(id) {
    return this.reach(`#${id}`);
  }

  /** Shows something of the panel, whichever tab or folds hide it. @param {string} selector */
  async reach(selector) {
    if ((await this.page.locator(`[data-expert]:is(${selector}, :has(${selector}))`).count()) > 0) await this.beExpert();
    const tab = await this.page.locator(`#sections > [data-tab]:is(${selector}, :has(${selector}))`).getAttribute("data-tab");
    const button = this.page.locator(`[data-tab-name="${tab}"]:not([aria-selected="true"])`);
    if (await button.isVisible()) await button.click();
    const folded = this.page.locator(`details:not([open]):is(${selector}, :has(${selector})) > summary`);
    while ((await folded.count()) > 0) await folded.first().click();
  }

  /** Shows technical controls and the numbers of points. */
  async beExpert() {
    await this.page.locator("#expert").setChecked(true, { force: true });
  }

  /** Finds a landmark by name or number. @param {string} text */
  async findLandmark(text) {
    await this.unfold("section-landmark");
    await this.page.fill("#landmark-search", text);
    await this.page.press("#landmark-search", "Enter");
  }

  /** Takes a whole part of the face in hand. @param {string} region its id, such as "left-brow" */
  async chooseRegion(region) {
    await this.unfold("section-landmark");
    await this.page.check("input[name='selection'][value='region']", { force: true });
    await this.page.selectOption("#region", region);
    await this.frames(3);
  }

  /** Where in the window the landmark is whose name is shown beside it. */
  async tagged() {
    await this.frames(3);
    const stage = await this.page.locator("#stage").boundingBox();
    const [x = 0, y = 0] = ((await this.page.getAttribute("#landmark-tag", "data-place")) ?? "").split(" ").map(Number.parseFloat);
    return { x: stage.x + x, y: stage.y + y };
  }

  /** Where in the window what is selected is. The pointer goes off the view for that: what it rests on would be named in its stead. */
  async selectedPlace() {
    await this.page.mouse.move(1, 1);
    return this.tagged();
  }

  /** Where in the window a landmark is; it is selected for that, and let go of again. @param {number} landmark */
  async landmarkPlace(landmark) {
    await this.findLandmark(String(landmark));
    const place = await this.selectedPlace();
    await this.page.focus("#viewport");
    await this.page.keyboard.press("Escape");
    return place;
  }

  /** A place of the window in the pixels of {@link view}. @param {{ x: number, y: number }} place */
  async onView({ x, y }) {
    const box = await this.page.locator("#viewport").boundingBox();
    const ratio = await this.page.evaluate(() => devicePixelRatio);
    return { x: (x - box.x) * ratio, y: (y - box.y) * ratio };
  }

  /**
   * Goes over the 3D view in so many rows and columns and, wherever something lights up, drags from there. Tells how many
   * places lit up, and those from which a drag did not move what was lit.
   *
   * @param {number} side
   */
  async takeAtEach(side) {
    const { page } = this;
    const view = await page.locator("#viewport").boundingBox();
    const turned = [];
    let lit = 0;
    for (let place = 0; place < side * side; place++) {
      const x = view.x + (view.width * ((place % side) + 0.43)) / side;
      const y = view.y + (view.height * (Math.floor(place / side) + 0.57)) / side;
      const isStage = await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.id === "viewport", [x, y]);
      if (!isStage) continue;
      await page.mouse.move(x, y);
      if ((await this.cursor()) !== "move") continue;
      const name = await page.textContent("#landmark-tag");
      lit += 1;
      await page.mouse.down();
      await page.mouse.move(x + 14, y + 14, { steps: 2 });
      await page.mouse.up();
      const [entry] = await this.history();
      if (entry !== name) turned.push({ x, y, name, entry });
      if (entry !== undefined) await page.keyboard.press("Control+z");
    }
    return { lit, turned };
  }

  /** A place of the window where the 3D view shows no face. */
  async besideTheFace() {
    const view = await this.page.locator("#viewport").boundingBox();
    return { x: view.x + 20, y: view.y + view.height / 2 };
  }

  /** The shape of the pointer over the 3D view. */
  cursor() {
    return this.page.locator("#viewport").evaluate((canvas) => getComputedStyle(canvas).cursor);
  }

  /**
   * Presses the pointer at a place of the window and moves it by so much.
   *
   * @param {{ x: number, y: number }} from
   * @param {{ x: number, y: number }} by
   */
  async grab(from, by) {
    await this.page.mouse.move(from.x, from.y);
    await this.page.mouse.down();
    await this.page.mouse.move(from.x + by.x, from.y + by.y, { steps: 6 });
  }

  /** The same, and lets go. @param {{ x: number, y: number }} from @param {{ x: number, y: number }} by */
  async drag(from, by) {
    await this.grab(from, by);
    await this.page.mouse.up();
    await this.frames(3);
  }

  /** Chooses how the face follows an edit. @param {"sculpt" | "paper"} preset */
  async prefer(preset) {
    await this.reach("[data-choice='preset']");
    await this.page.check(`input[name="preset"][value="${preset}"]`, { force: true });
  }

  /** Types an offset into the number field of an axis. @param {"x" | "y" | "z"} axis @param {number} offset_mm */
  async offset(axis, offset_mm) {
    await this.unfold("section-landmark");
    await this.#enter(`#landmark-sliders [data-axis="${axis}"]`, offset_mm);
  }

  /** Moves a landmark along an axis. @param {string} landmark @param {"x" | "y" | "z"} axis @param {number} offset_mm */
  async move(landmark, axis, offset_mm) {
    await this.findLandmark(landmark);
    await this.offset(axis, offset_mm);
  }

  /** Types into the number field of a ready-made slider. @param {string} slider its id, such as "nose-width" @param {number} amount_mm */
  async slide(slider, amount_mm) {
    await this.unfold("section-face");
    await this.#enter(`[data-slider="${slider}"]`, amount_mm);
  }

  /** @param {string} slider @param {number} amount_mm */
  async #enter(slider, amount_mm) {
    const field = this.page.locator(`${slider} input[type=number]`);
    await field.fill(String(amount_mm));
    await field.press("Tab");
    await this.frames(3);
  }

  /** @param {string} slider */
  async sliderValue(slider) {
    return Number(await this.page.inputValue(`[data-slider="${slider}"] input[type=number]`));
  }

  /** What the history lists, newest first. */
  async history() {
    return this.page.locator("#history .what").allInnerTexts();
  }

  /** The number of the landmark that is being edited. */
  async landmark() {
    return Number((await this.page.inputValue("#landmark-search")).match(/\d+$/)?.[0]);
  }

  /** The number of the point of a dense mesh that is being edited. */
  async point() {
    return Number((await this.page.inputValue("#landmark-search")).match(/[\d,]+/)?.[0].replaceAll(",", ""));
  }

  /** The anchors of the edit, as the panel names them. */
  async anchors() {
    const text = await this.page.locator("#landmark-anchors").getAttribute("data-anchors");
    return (text ?? "").split(" ").filter(Boolean).map(Number);
  }

  /** @param {"mm" | "image"} units */
  async meshJson(units) {
    await this.unfold("section-export");
    // Only experts see it.
    await this.page.locator(`input[name="export-units"][value="${units}"]`).evaluate((input) => input.click());
    const [download] = await Promise.all([
      this.page.waitForEvent("download"),
      this.page.dispatchEvent("[data-action='download-json']", "click"),
    ]);
    return JSON.parse(await readFile(await download.path(), "utf8"));
  }

  /** The file that a button saves. @param {string} action */
  async download(action) {
    return (await this.save(action)).bytes;
  }

  /** The same with its name. @param {string} action */
  async save(action) {
    await this.unfold("section-export");
    if (await this.page.locator(`#sections [data-action="${action}"]`).count()) await this.reach(`[data-action="${action}"]`);
    const [download] = await Promise.all([
      this.page.waitForEvent("download"),
      this.page.click(`#panel [data-action="${action}"]`),
    ]);
    return { bytes: await readFile(await download.path()), name: download.suggestedFilename() };
  }

  /** The pixels of the 3D view once it has come to rest, with what floats over it left out. */
  async view() {
    assert.ok(this.sees, 'screenshots do not show the 3D view here: the test has to say that it needs "eyes"');
    await this.#showFloating("hidden");
    let shot = await this.#shot();
    for (let tries = 0; tries < MOST_SHOTS; tries += 1) {
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

  /** @param {"" | "hidden"} visibility of whatever floats over the 3D view */
  #showFloating(visibility) {
    return this.page.evaluate((visibility) => {
      for (const element of document.querySelectorAll(".stage > :not(.viewport)")) element.style.visibility = visibility;
    }, visibility);
  }

  /** What the notice says, once there is one. */
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

/** Runs in the page, or in an empty one that stores nothing. */
function rememberExpert() {
  try {
    localStorage.setItem("rosto.expert", "on");
  } catch {
    // The page itself runs it again.
  }
}
