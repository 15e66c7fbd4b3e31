import { make } from "../js/page/dom.js";
import { inEveryLanguage, say } from "../js/words/words.js";
import { STYLES } from "./styles.js";

/**
 * What the shadow of an element holds.
 *
 * @typedef {object} Stage
 * @property {HTMLDivElement} root
 * @property {HTMLSlotElement} slot for the photo
 * @property {HTMLCanvasElement} canvas
 * @property {HTMLOutputElement} tag
 * @property {HTMLDivElement} progress a word and a bar
 * @property {HTMLParagraphElement} notice
 * @property {HTMLDivElement} toolbar
 *
 * @typedef {"undo" | "redo" | "reset" | "download"} Tool
 */

/** Each tool with its word and its lines. @type {Record<Tool, { word: import("../js/words/words.js").WordKey, lines: string }>} */
const TOOLS = {
  undo: { word: "undo", lines: "M7.5 4.5 4 8l3.5 3.5M4 8h7.5a4 4 0 0 1 0 8H9" },
  redo: { word: "redo", lines: "M12.5 4.5 16 8l-3.5 3.5M16 8H8.5a4 4 0 0 0 0 8H11" },
  reset: { word: "reset", lines: "M15.5 10A5.5 5.5 0 1 1 10 4.5h4M11.5 2 14 4.5 11.5 7" },
  download: { word: "export.glb", lines: "M10 3v10m-4-4 4 4 4-4M3.5 16.5h13" },
};

/** Shared by all elements. @type {CSSStyleSheet | undefined} */
let sheet;

/**
 * Fills a shadow with a stage of its own, in place of what was there: a canvas that was drawn on once is of no further use.
 *
 * @param {ShadowRoot} shadow
 * @returns {Stage}
 */
export function buildStage(shadow) {
  sheet ??= new CSSStyleSheet();
  sheet.replaceSync(STYLES);
  shadow.adoptedStyleSheets = [sheet];
  const stage = {
    root: make("div", "stage"),
    slot: make("slot"),
    canvas: make("canvas"),
    tag: make("output", "tag"),
    progress: make("div", "progress"),
    notice: make("p", "notice"),
    toolbar: make("div", "toolbar"),
  };
  stage.canvas.tabIndex = 0;
  stage.canvas.setAttribute("role", "application");
  stage.notice.setAttribute("role", "alert");
  stage.toolbar.setAttribute("role", "toolbar");
  for (const part of [stage.tag, stage.progress, stage.notice, stage.toolbar]) part.hidden = true;
  stage.progress.append(make("span"), make("progress"));
  stage.root.append(stage.slot, stage.canvas, stage.tag, stage.progress, stage.notice, stage.toolbar);
  shadow.replaceChildren(stage.root);
  return stage;
}

/**
 * Puts a button for each tool on the stage.
 *
 * @param {Stage} stage
 * @param {(tool: Tool) => void} use
 */
export function addTools({ toolbar }, use) {
  for (const [name, { lines }] of Object.entries(TOOLS)) {
    const tool = /** @type {Tool} */ (name);
    const button = make("button");
    button.type = "button";
    button.dataset["tool"] = tool;
    button.append(drawn(lines));
    button.addEventListener("click", () => use(tool));
    toolbar.append(button);
  }
}

/**
 * Says on the stage what its parts are called, in whatever language is spoken.
 *
 * @param {Stage} stage
 * @param {AbortSignal} gone
 */
export function nameParts({ canvas, toolbar }, gone) {
  inEveryLanguage(() => {
    canvas.ariaLabel = say("viewport.label");
    canvas.ariaDescription = say("element.keys");
    toolbar.ariaLabel = say("toolbar.label");
    for (const button of toolbar.querySelectorAll("button")) {
      const { word } = TOOLS[/** @type {Tool} */ (button.dataset["tool"])];
      button.ariaLabel = say(word);
      button.title = say(word);
    }
  }, gone);
}

/** @param {string} lines */
function drawn(lines) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", lines);
  svg.append(path);
  return svg;
}
