// Looks over a page for what a visitor would stumble over: things that overlap, leave the window, are cut or covered. The
// functions below run in the page, all of them together.

/** Boxes that share no more than this are apart, in CSS px: browsers lay out in fractions of them. */
const SLACK_PX = 1;

/** A closed list shows its choice beside an arrow this wide, in CSS px. */
const SELECT_ARROW_PX = 20;

const IN_PAGE = [
  isSeen, nameOf, floats, overlap, overlapping, boxes, hasOwnText, edgeOf, leaving, spilling, textOf, outside,
  isWrapped, cutting, cutChoice, cutValue, controls, reachable, covered, sideways, lookOver, lyingOver,
];
const SOURCE = [`const SLACK_PX = ${SLACK_PX}, SELECT_ARROW_PX = ${SELECT_ARROW_PX};`, ...IN_PAGE.map(String)].join("\n");

/**
 * What is wrong with the boxes of the page as it stands; nothing if nothing is.
 *
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
export function findings(page) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn lookOver(); })()`);
}

/**
 * What floats or stands over a box of the stage: over the chin, say.
 *
 * @param {import("playwright-core").Page} page
 * @param {{ left: number, top: number, right: number, bottom: number }} box in CSS px of the window
 * @returns {Promise<string[]>}
 */
export function over(page, box) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn lyingOver(${JSON.stringify(box)}); })()`);
}

/** @returns {string[]} */
function lookOver() {
  const modal = document.querySelector("dialog:modal");
  const scope = modal ?? document.body;
  const all = [...scope.querySelectorAll("*")].filter(isSeen);
  const found = [...(modal ? [] : overlapping()), ...leaving(all), ...spilling(all), ...cutting(all), ...covered(scope), ...sideways()];
  return [...new Set(found)];
}

/** @param {Element} element */
function isSeen(element) {
  if (element.closest(".visually-hidden, .skip-link, .symbols, svg *")) return false;
  const { width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && element.checkVisibility({ visibilityProperty: true });
}

/** @param {Element} element */
function nameOf(element) {
  if (element.id) return `#${element.id}`;
  const words = (element.textContent ?? "").trim().replaceAll(/\s+/g, " ").slice(0, 32);
  const kind = element.tagName.toLowerCase() + [...element.classList].map((name) => `.${name}`).join("");
  const section = element.closest("[id]");
  return `${section ? `#${section.id} ` : ""}${kind}${words ? ` “${words}”` : ""}`;
}

/** Whatever floats over the 3D view, each for itself; what has the whole stage to itself for a moment is not meant. */
function floats() {
  const outer = document.querySelectorAll(".stage > :not(.viewport, .visually-hidden, .welcome, .drop-veil, .wipe), #toast, #faces");
  const all = new Set([...outer, ...document.querySelectorAll(".welcome > *")]);
  return [...all].filter((element) => isSeen(element) && element.checkVisibility({ opacityProperty: true }));
}

/** @param {Element} one @param {Element} other */
function overlap(one, other) {
  const [a, b] = [one.getBoundingClientRect(), other.getBoundingClientRect()];
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return width > SLACK_PX && height > SLACK_PX ? `${Math.round(width)} × ${Math.round(height)} px` : undefined;
}

function overlapping() {
  const floating = floats();
  const fixed = ["panel"].map((id) => document.getElementById(id)).filter((element) => element && isSeen(element));
  const found = [];
  for (const [place, one] of floating.entries()) {
    for (const other of [...floating.slice(place + 1), ...fixed]) {
      // A name beside a landmark goes with it, below a message that stays for a moment, too.
      const isPassing = [one, other].some(({ id }) => id === "landmark-tag") && [one, other].some(({ id }) => id === "notice" || id === "progress");
      const shared = isPassing || one.contains(other) || other.contains(one) ? undefined : overlap(one, other);
      if (shared) found.push(`${nameOf(one)} and ${nameOf(other)} overlap by ${shared}`);
    }
  }
  const stage = document.getElementById("stage");
  for (const panel of fixed) if (overlap(panel, stage)) found.push(`the stage and ${nameOf(panel)} overlap by ${overlap(panel, stage)}`);
  return found;
}

/** @param {{ left: number, top: number, right: number, bottom: number }} box */
function lyingOver(box) {
  const panel = document.getElementById("panel");
  return [...floats(), ...(panel && isSeen(panel) ? [panel] : [])]
    .filter((element) => overlap(element, { getBoundingClientRect: () => box }))
    .map(nameOf);
}

/** @param {Element} element */
function hasOwnText(element) {
  return [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && (node.textContent ?? "").trim() !== "");
}

/** @param {Element} element */
function boxes(element) {
  const { left, right, top, bottom } = element.getBoundingClientRect();
  return { left, right, top, bottom };
}

/** How far a box reaches beyond another's edges, sideways and up or down. */
function edgeOf(box, frame) {
  const across = Math.max(frame.left - box.left, box.right - frame.right);
  const along = Math.max(frame.top - box.top, box.bottom - frame.bottom);
  return { across: Math.round(across), along: Math.round(along) };
}

/** What stands where nobody sees it, though nothing there scrolls. */
function leaving(all) {
  const found = [];
  for (const element of all) {
    const isFloat = element.parentElement?.id === "stage" && element.id !== "viewport";
    if (!isFloat && !hasOwnText(element) && !element.matches("button, input, select, canvas:not(#viewport), progress")) continue;
    if (element.matches("#drop-veil, #drop-veil *")) continue;
    const out = outside(element);
    if (out) found.push(`${nameOf(element)} ${out}`);
  }
  return found;
}

/** @param {Element} element */
function outside(element) {
  const box = boxes(element);
  let scrolls = false;
  for (let up = element.parentElement; up && up !== document.documentElement; up = up.parentElement) {
    const { overflowX, overflowY } = getComputedStyle(up);
    if (overflowX === "visible" && overflowY === "visible") continue;
    const { across, along } = edgeOf(box, boxes(up));
    if (across > SLACK_PX && overflowX !== "visible") return `leaves ${nameOf(up)} sideways by ${across} px`;
    scrolls ||= /auto|scroll/.test(overflowY);
    if (!scrolls && along > SLACK_PX && overflowY !== "visible") return `leaves ${nameOf(up)} by ${along} px`;
  }
  const { across, along } = edgeOf(box, { left: 0, top: 0, right: innerWidth, bottom: innerHeight });
  if (across > SLACK_PX) return `leaves the window sideways by ${across} px`;
  return !scrolls && along > SLACK_PX ? `leaves the window by ${along} px` : undefined;
}

/** Text wider than its box: it is cut there, or runs over what stands beside it. */
function spilling(all) {
  return all
    .filter((element) => element.clientWidth > 0 && hasOwnText(element) && getComputedStyle(element).textOverflow !== "ellipsis")
    .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + SLACK_PX)
    .map((element) => `the text of ${nameOf(element)} is ${element.scrollWidth - element.clientWidth} px wider than its box`);
}

/** Where the text of an element stands, line by line. @param {Element} element */
function textOf(element) {
  const range = document.createRange();
  range.selectNodeContents(element);
  return [...range.getClientRects()].filter(({ width, height }) => width > 0 && height > 0);
}

/** Segments and tabs keep to one line, whatever the language. @param {Element} element */
function isWrapped(element) {
  const lines = textOf(element).toSorted((a, b) => a.top - b.top);
  return lines.some((line, place) => place > 0 && line.top >= lines[place - 1].bottom - 2);
}

/** What is cut within buttons, labels, segments and fields. */
function cutting(all) {
  const found = [];
  for (const element of all.filter((one) => one.matches("button, label, summary, [role=tab], .choice-options span"))) {
    if (element.clientHeight > 0 && element.scrollHeight > element.clientHeight + SLACK_PX) found.push(`${nameOf(element)} is cut by ${element.scrollHeight - element.clientHeight} px`);
    const out = textOf(element).map((line) => edgeOf(line, boxes(element))).find(({ across, along }) => across > SLACK_PX || along > 2);
    if (out && !element.matches("label:has(select, input)")) found.push(`the text of ${nameOf(element)} leaves it by ${Math.max(out.across, out.along)} px`);
    if (element.matches("[role=tab], .choice-options span") && isWrapped(element)) found.push(`the text of ${nameOf(element)} wraps`);
  }
  return [...found, ...all.map(cutChoice), ...all.map(cutValue)].filter(Boolean);
}

/** @param {Element} select */
function cutChoice(select) {
  if (!(select instanceof HTMLSelectElement)) return undefined;
  const style = getComputedStyle(select);
  const pen = new OffscreenCanvas(1, 1).getContext("2d");
  pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  const text = select.selectedOptions[0]?.text ?? "";
  const room_px = select.clientWidth - Number.parseFloat(style.paddingLeft) - Number.parseFloat(style.paddingRight) - SELECT_ARROW_PX;
  const lack_px = Math.round(pen.measureText(text).width - room_px);
  return lack_px > SLACK_PX ? `${nameOf(select)} cuts “${text}” by ${lack_px} px` : undefined;
}

/** @param {Element} input */
function cutValue(input) {
  if (!(input instanceof HTMLInputElement) || !input.matches("[type=text], [type=number], :not([type])")) return undefined;
  const lack_px = input.scrollWidth - input.clientWidth;
  return lack_px > SLACK_PX ? `${nameOf(input)} cuts “${input.value}” by ${lack_px} px` : undefined;
}

/** @param {Element} scope */
function controls(scope) {
  const all = scope.querySelectorAll("button, input, select, textarea, summary, a[href], [role=button], [role=tab]");
  return [...all].filter((element) => isSeen(element) && getComputedStyle(element).pointerEvents !== "none");
}

/** Whether a place is within all that scrolls around an element. */
function reachable(element, x, y) {
  for (let up = element.parentElement; up && up !== document.documentElement; up = up.parentElement) {
    const { overflowX, overflowY } = getComputedStyle(up);
    if (overflowX === "visible" && overflowY === "visible") continue;
    const { left, right, top, bottom } = up.getBoundingClientRect();
    if (x < left || x > right || y < top || y > bottom) return false;
  }
  return x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight;
}

/** Controls whose middle something else takes the presses of. @param {Element} scope */
function covered(scope) {
  const found = [];
  for (const element of controls(scope)) {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const hit = reachable(element, x, y) ? document.elementFromPoint(x, y) : undefined;
    if (!hit || element.contains(hit) || element.closest("label")?.contains(hit)) continue;
    if ([...(element.labels ?? [])].some((label) => label.contains(hit))) continue;
    found.push(`${nameOf(element)} is covered by ${nameOf(hit)}`);
  }
  return found;
}

function sideways() {
  const found = [];
  const { scrollWidth, scrollHeight } = document.documentElement;
  if (scrollWidth > innerWidth) found.push(`the page scrolls sideways by ${scrollWidth - innerWidth} px`);
  if (scrollHeight > innerHeight) found.push(`the page scrolls by ${scrollHeight - innerHeight} px`);
  for (const element of [...document.querySelectorAll(".panel, .sections, .section-body, dialog[open]")].filter(isSeen)) {
    const over_px = element.scrollWidth - element.clientWidth;
    if (over_px > SLACK_PX) found.push(`${nameOf(element)} scrolls sideways by ${over_px} px`);
    if (element.matches("dialog") && element.scrollTop > 0) found.push(`${nameOf(element)} opens ${element.scrollTop} px below its top`);
  }
  return found;
}
