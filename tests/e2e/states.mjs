import { readFile } from "node:fs/promises";
import { findings } from "./boxes.mjs";
import { openGroup } from "./groups.mjs";
import { Pointer } from "./pointer.mjs";
import { untilSaved } from "./storage.mjs";
import { faceless } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** @typedef {import("./visitor.mjs").Visitor} Visitor */

/**
 * A state of the page that can be reached from each state before it in the list that has a face.
 *
 * @typedef {object} State
 * @property {string} id
 * @property {(visitor: Visitor) => Promise<void>} enter
 * @property {(visitor: Visitor) => Promise<void>} [leave]
 */

/** @type {State[]} */
export const STATES = [
  { id: "empty", enter: (visitor) => visitor.untilLoaded() },
  { id: "working", enter: startWork, leave: finishWork },
  { id: "arrived", enter: haveFace },
  { id: "selected", enter: selectNose },
  { id: "dragging", enter: grabNose, leave: releaseNose },
  { id: "region", enter: selectRegion, leave: ({ page }) => page.check("input[name='selection'][value='landmark']", { force: true }) },
  { id: "compare", enter: compare, leave: stopComparing },
  { id: "view", enter: (visitor) => openTab(visitor, "view"), leave: (visitor) => openTab(visitor, "shape") },
  { id: "export", enter: (visitor) => openTab(visitor, "export"), leave: (visitor) => openTab(visitor, "shape") },
  { id: "downloaded", enter: download, leave: (visitor) => openTab(visitor, "shape") },
  { id: "notice", enter: fail, leave: ({ page }) => close(page, "#notice-close", "#notice") },
  {
    id: "keys",
    enter: ({ page }) => page.evaluate(() => document.getElementById("keys").showModal()),
    leave: ({ page }) => close(page, "[data-action='close-keys']", "#keys"),
  },
  { id: "group", enter: (visitor) => openGroup(visitor, "the two of us.png") },
  { id: "returning", enter: returnToStart },
];

/**
 * Allows the worker's reply to be delayed; pass it as `before`.
 *
 * @param {import("@playwright/test").BrowserContext} context
 */
export function allowDelayedReplies(context) {
  return context.addInitScript(delayReplies);
}

/**
 * Problems of the current state: layout findings, and an unexpected notice.
 *
 * @param {Visitor} visitor
 * @param {State} state
 * @returns {Promise<string[]>}
 */
export async function problemsOf({ page }, { id }) {
  const notice = page.locator("#notice");
  const isStray = id !== "notice" && (await notice.isVisible());
  return [...(isStray ? [`a notice: ${await notice.getAttribute("data-code")}`] : []), ...(await findings(page))];
}

// Transitions into and out of the states.

async function startWork(visitor) {
  const { page } = visitor;
  await page.evaluate("repliesWait = true");
  await visitor.untilInteractive();
  await page.setInputFiles("#photo-file", { name: "portrait.png", mimeType: "image/png", buffer: await readFile(SAMPLE) });
  await page.waitForSelector("#progress");
  await page.waitForSelector("[data-step='landmarks'][aria-current]");
}

async function finishWork(visitor) {
  await visitor.page.evaluate("releaseReplies()");
  await visitor.untilFace();
}

/** Runs in the page before its own scripts: delays the worker's replies while `repliesWait` is set. */
function delayReplies() {
  /** @type {(() => void)[]} */
  const held = [];
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function (type, listener, ...rest) {
    const deliver = (event) => {
      if (window["repliesWait"] && event.data?.type === "open") held.push(() => listener.call(this, event));
      else listener.call(this, event);
    };
    listen.call(this, type, type === "message" ? deliver : listener, ...rest);
  };
  window["releaseReplies"] = () => {
    window["repliesWait"] = false;
    for (const deliver of held.splice(0)) deliver();
  };
}

async function haveFace(visitor) {
  const state = await visitor.page.getAttribute("body", "data-state");
  if (state !== "face") await visitor.dropSample();
}

async function selectNose(visitor) {
  await openTab(visitor, "shape");
  // The number works in each language.
  await visitor.findLandmark("1");
  await blur(visitor);
}

async function grabNose(visitor) {
  await selectNose(visitor);
  const nose = await visitor.tagPosition();
  const pointer = await Pointer.of(visitor);
  await pointer.press(nose);
  const { height } = await visitor.page.locator("#viewport").boundingBox();
  await pointer.move(nose, { x: nose.x + 0.015 * height, y: nose.y - 0.03 * height });
  await visitor.frames(3);
}

async function releaseNose(visitor) {
  const pointer = await Pointer.of(visitor);
  await pointer.release();
  await visitor.frames(3);
}

async function selectRegion(visitor) {
  await openTab(visitor, "shape");
  await visitor.selectRegion("nose");
  await blur(visitor);
}

async function compare(visitor) {
  await visitor.page.click("#compare");
  await visitor.frames(3);
}

async function stopComparing({ page }) {
  if ((await page.getAttribute("#compare", "aria-pressed")) === "true") await page.click("#compare");
}

async function openTab(visitor, name) {
  const tab = visitor.page.locator(`#tab-${name}`);
  if (await tab.isVisible()) await tab.click();
  else if (name !== "shape") await visitor.unfold(`section-${name}`);
  await blur(visitor);
}

async function download(visitor) {
  await visitor.download("download-glb");
  await visitor.page.waitForSelector("#toast");
}

async function fail(visitor) {
  await visitor.drop(faceless(), "meadow.png");
  await visitor.notice();
}

async function close(page, button, closed) {
  await page.click(button);
  await page.waitForSelector(closed, { state: "hidden" });
}

async function returnToStart(visitor) {
  await untilSaved(visitor.page);
  await visitor.page.reload();
  await visitor.page.waitForSelector("#continue:not([hidden])");
  await visitor.untilLoaded();
}

async function blur({ page }) {
  await page.evaluate(() => document.activeElement?.blur());
}
