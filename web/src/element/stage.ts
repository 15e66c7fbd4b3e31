import { make } from "../page/dom.ts";
import { onLocaleChange, isWord, t } from "../words/words.ts";
import { STYLES } from "./styles.ts";
import type { WordKey } from "../words/words.ts";
import type { Stage as Step } from "../worker/protocol.ts";
import type { RostoError } from "./rosto-error.ts";

export type Tool = "undo" | "redo" | "reset" | "download";

/** Errors that prevent the 3D view; the element then shows the photo unchanged. */
const WITHOUT_3D = /^(no-web|no-adapter|no-device|canvas-in-use)/;

/** Label key and icon path of each tool. */
const TOOLS: Record<Tool, { word: WordKey; lines: string; }> = {
  undo: { word: "undo", lines: "M7.5 4.5 4 8l3.5 3.5M4 8h7.5a4 4 0 0 1 0 8H9" },
  redo: { word: "redo", lines: "M12.5 4.5 16 8l-3.5 3.5M16 8H8.5a4 4 0 0 0 0 8H11" },
  reset: { word: "reset", lines: "M4.5 10A5.5 5.5 0 1 0 10 4.5H6M8.5 2 6 4.5 8.5 7" },
  download: { word: "export.glb", lines: "M10 3v10m-4-4 4 4 4-4M3.5 16.5h13" },
};

/** Shared by all elements, created on first use. */
let sheet: CSSStyleSheet | undefined;

/** The shadow DOM of an element: the photo, the canvas over it, the tools, progress and notices. */
export class Stage {
  #root = make("div", "stage");
  #progress = make("div", "progress");
  #label = make("span");
  #bar = make("progress");
  #notice = make("p", "notice");
  #noticeOwner: string | undefined;
  #toolbar = make("div", "toolbar");
  /** For the page's photo. */
  slot = make("slot");
  canvas = make("canvas");
  /** Name of the active landmark. */
  tag = make("output", "tag");

  /** Replaces the content of a shadow root: a canvas cannot be reused with another device. */
  constructor(shadow: ShadowRoot) {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.#notice.setAttribute("role", "alert");
    this.#toolbar.setAttribute("role", "toolbar");
    for (const part of [this.tag, this.#progress, this.#notice, this.#toolbar]) part.hidden = true;
    this.#progress.append(this.#label, this.#bar);
    this.#root.append(this.slot, this.canvas, this.tag, this.#progress, this.#notice, this.#toolbar);
    shadow.adoptedStyleSheets = [styles()];
    shadow.replaceChildren(this.#root);
  }

  /**
   * Adds the tool buttons, and labels all parts in the current language.
   *
   * @param signal for teardown
   */
  addTools(use: (tool: Tool) => void, signal: AbortSignal) {
    const tools = (Object.entries(TOOLS) as [Tool, { word: WordKey, lines: string }][]);
    const buttons = tools.map(([tool, { lines }]) => button(tool, lines, () => use(tool)));
    this.#toolbar.append(...buttons);
    onLocaleChange(() => {
      this.canvas.ariaLabel = t("viewport.label");
      this.canvas.ariaDescription = t("element.keys");
      this.#toolbar.ariaLabel = t("toolbar.label");
      for (const [at, [, { word }]] of tools.entries()) Object.assign(buttons[at] ?? {}, { ariaLabel: t(word), title: t(word) });
    }, signal);
  }

  /** Shows the canvas in place of the photo. */
  showFace() {
    this.#root.dataset["state"] = "face";
    this.hideProgress();
    this.hideNotice();
  }

  /**
   * Shows the progress of a photo.
   *
   * @param fraction of the whole, 0 to 1
   */
  showProgress(step: Step | "loading", fraction: number) {
    this.#progress.hidden = false;
    this.hideNotice();
    this.#label.textContent = t(step === "loading" ? "progress.loading" : "progress.working");
    this.#bar.ariaLabel = this.#label.textContent;
    if (step === "loading") this.#bar.removeAttribute("value");
    else this.#bar.value = fraction;
  }

  hideProgress() {
    this.#progress.hidden = true;
  }

  /**
   * Shows an error.
   *
   * @param owner part of the program that may hide it
   */
  showNotice({ code, message }: RostoError, owner?: string) {
    this.#noticeOwner = owner;
    this.hideProgress();
    this.#notice.hidden = false;
    this.#notice.textContent = wordsFor(code) || message;
  }

  /** @param owner whose notice to hide; any notice if omitted */
  hideNotice(owner?: string) {
    if (owner === undefined || owner === this.#noticeOwner) this.#notice.hidden = true;
  }

  /** Shows the tools if a face is open. Returns the height that they cover at the bottom of the stage, in CSS px. */
  showTools(wanted: boolean) {
    this.#toolbar.hidden = !wanted || this.#root.dataset["state"] !== "face";
    return this.#toolbar.hidden ? 0 : this.#root.clientHeight - this.#toolbar.offsetTop;
  }

  enableTools(usable: Record<Tool, boolean>) {
    for (const tool of this.#toolbar.querySelectorAll("button")) tool.disabled = !usable[(tool.dataset["tool"] as Tool)];
  }
}

function styles() {
  if (sheet) return sheet;
  sheet = new CSSStyleSheet();
  sheet.replaceSync(STYLES);
  return sheet;
}

/** The error's title and hint. An element saves no work, so the hint for unsaved work is preferred. */
function wordsFor(code: string) {
  const [title, hint] = [`error.${code}`, `error.${code}.hint`];
  const unsaved = `${hint}.unkept`;
  const next = WITHOUT_3D.test(code) ? "element.no-3d" : isWord(unsaved) ? unsaved : hint;
  return [title, next].filter(isWord).map((word) => t(word)).join(". ");
}

function button(tool: Tool, lines: string, use: () => void) {
  const made = make("button");
  made.type = "button";
  made.dataset["tool"] = tool;
  made.append(icon(lines));
  made.addEventListener("click", use);
  return made;
}

function icon(lines: string) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", lines);
  svg.append(path);
  return svg;
}
