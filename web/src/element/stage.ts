import { make } from "../page/dom.ts";
import { isWord, t } from "../words/words.ts";
import styles from "./stage.css";
import type { WordKey } from "../words/words.ts";
import type { RostoError } from "./checks.ts";

const SVG = "http://www.w3.org/2000/svg";

/** Errors that prevent the 3D view; the element then shows the photo unchanged. */
const WITHOUT_3D = /^(no-web|no-adapter|no-device|canvas-in-use)/;

/** Label key and icon path of each tool. */
const TOOLS = {
  undo: ["undo", "M7.5 4.5 4 8l3.5 3.5M4 8h7.5a4 4 0 0 1 0 8H9"],
  redo: ["redo", "M12.5 4.5 16 8l-3.5 3.5M16 8H8.5a4 4 0 0 0 0 8H11"],
  reset: ["reset", "M4.5 10A5.5 5.5 0 1 0 10 4.5H6M8.5 2 6 4.5 8.5 7"],
  download: ["export.glb", "M10 3v10m-4-4 4 4 4-4M3.5 16.5h13"],
} satisfies Record<string, [WordKey, string]>;

export type Tool = keyof typeof TOOLS;

/** The shadow DOM of an element: the photo, the canvas over it, the tools, progress and notices. */
export class Stage {
  canvas = make("canvas");
  /** Name of the active landmark. */
  tag = make("output", "tag");
  #root = make("div", "stage");
  #progress = make("label", "progress");
  #step = make("span");
  #bar = make("progress");
  #notice = make("p", "notice");
  #noticeOwner: string | undefined;
  #toolbar = make("div", "toolbar");

  /** Replaces the content of a shadow root: a canvas cannot be reused with another device. */
  constructor(shadow: ShadowRoot, use: (tool: Tool) => void) {
    this.canvas.tabIndex = 0;
    [this.canvas.role, this.#notice.role, this.#toolbar.role] = ["application", "alert", "toolbar"];
    for (const part of [this.tag, this.#progress, this.#notice, this.#toolbar]) part.hidden = true;
    this.#progress.append(this.#step, this.#bar);
    for (const [tool, [, lines]] of Object.entries(TOOLS)) this.#toolbar.append(button(tool as Tool, lines, use));
    this.#root.append(make("slot"), this.canvas, this.tag, this.#progress, this.#notice, this.#toolbar);
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(styles);
    shadow.adoptedStyleSheets = [sheet];
    shadow.replaceChildren(this.#root);
  }

  /** Labels all parts in the current language. */
  translate() {
    [this.canvas.ariaLabel, this.canvas.ariaDescription] = [t("viewport.label"), t("element.keys")];
    this.#toolbar.ariaLabel = t("toolbar.label");
    for (const button of this.#toolbar.querySelectorAll("button")) {
      const [word] = TOOLS[button.dataset["tool"] as Tool];
      button.ariaLabel = button.title = t(word);
    }
  }

  /** Shows the canvas in place of the photo. */
  showFace() {
    this.#root.dataset["state"] = "face";
    this.showProgress();
    this.hideNotice();
  }

  /**
   * Shows the progress of a photo; hides it without a step.
   *
   * @param fraction of the whole, 0 to 1
   */
  showProgress(step?: string, fraction = 0) {
    this.#progress.hidden = step === undefined;
    if (step === undefined) return;
    this.hideNotice();
    this.#step.textContent = t(step === "loading" ? "progress.loading" : "progress.working");
    if (step === "loading") this.#bar.removeAttribute("value");
    else this.#bar.value = fraction;
  }

  /**
   * Shows an error. An element saves no work, so the hint for unsaved work is preferred.
   *
   * @param owner part of the program that may hide it
   */
  showNotice({ code, message }: RostoError, owner?: string) {
    const hints = WITHOUT_3D.test(code) ? ["element.no-3d"] : [`error.${code}.hint.unkept`, `error.${code}.hint`];
    const words = [[`error.${code}`], hints].flatMap((keys) => keys.find(isWord) ?? []);
    this.#noticeOwner = owner;
    this.showProgress();
    this.#notice.hidden = false;
    this.#notice.textContent = words.map((word) => t(word)).join(". ") || message;
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
    for (const tool of this.#toolbar.querySelectorAll("button")) tool.disabled = !usable[tool.dataset["tool"] as Tool];
  }
}

function button(tool: Tool, lines: string, use: (tool: Tool) => void) {
  const made = make("button");
  [made.type, made.dataset["tool"]] = ["button", tool];
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.append(document.createElementNS(SVG, "path"));
  svg.firstElementChild?.setAttribute("d", lines);
  made.append(svg);
  made.addEventListener("click", () => use(tool));
  return made;
}
