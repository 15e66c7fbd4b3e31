// Elements that leave the window, and text that is cut. Runs in the page.
import { edgeOf, hasOwnText, isSeen, nameOf, SLACK_PX, textOf } from "./basics.mjs";

/** Width of the arrow of a closed select, in CSS px. */
export const SELECT_ARROW_PX = 20;

/** Elements outside their clipping container or the window that cannot be scrolled to. */
export function leaving(all) {
  const isFloat = (element) => element.parentElement?.id === "stage" && element.id !== "viewport";
  const isControl = (element) => element.matches("button, input, select, canvas:not(#viewport), progress");
  return all
    .filter((element) => isFloat(element) || hasOwnText(element) || isControl(element))
    .filter((element) => !element.matches("#drop-veil, #drop-veil *"))
    .map(outside);
}

/** @param {Element} element */
export function outside(element) {
  const box = element.getBoundingClientRect();
  let scrolls = false;
  for (let up = element.parentElement; up && up !== document.documentElement; up = up.parentElement) {
    const { display, overflowX, overflowY } = getComputedStyle(up);
    // It has no box.
    if (display === "contents") continue;
    if (overflowX === "visible" && overflowY === "visible") continue;
    const { across, along } = edgeOf(box, up.getBoundingClientRect());
    if (across > SLACK_PX && overflowX !== "visible") return `${nameOf(element)} leaves ${nameOf(up)} sideways by ${across} px`;
    scrolls ||= /auto|scroll/.test(overflowY);
    if (!scrolls && along > SLACK_PX && overflowY !== "visible") return `${nameOf(element)} leaves ${nameOf(up)} by ${along} px`;
  }
  const { across, along } = edgeOf(box, { left: 0, top: 0, right: innerWidth, bottom: innerHeight });
  if (across > SLACK_PX) return `${nameOf(element)} leaves the window sideways by ${across} px`;
  return !scrolls && along > SLACK_PX ? `${nameOf(element)} leaves the window by ${along} px` : undefined;
}

/** Text wider than its box. */
export function spilling(all) {
  return all
    .filter((element) => element.clientWidth > 0 && hasOwnText(element) && getComputedStyle(element).textOverflow !== "ellipsis")
    .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + SLACK_PX)
    .map((element) => `the text of ${nameOf(element)} is ${element.scrollWidth - element.clientWidth} px wider than its box`);
}

/** Text cut within buttons, labels, segments and fields. */
export function cutting(all) {
  const found = [];
  for (const element of all.filter((one) => one.matches("button, label, summary, [role=tab], .choice-options span"))) {
    const { clientHeight, scrollHeight } = element;
    if (clientHeight > 0 && scrollHeight > clientHeight + SLACK_PX) found.push(`${nameOf(element)} is cut by ${scrollHeight - clientHeight} px`);
    const box = element.getBoundingClientRect();
    const out = textOf(element).map((line) => edgeOf(line, box)).find(({ across, along }) => across > SLACK_PX || along > 2);
    if (out && !element.matches("label:has(select, input)")) found.push(`the text of ${nameOf(element)} leaves it by ${Math.max(out.across, out.along)} px`);
    if (element.matches("[role=tab], .choice-options:not(.icons) span") && isWrapped(element)) found.push(`the text of ${nameOf(element)} wraps`);
  }
  return [...found, ...all.map(cutChoice), ...all.map(cutValue)];
}

/** Segments and tabs have one line in each language. @param {Element} element */
export function isWrapped(element) {
  const lines = textOf(element).toSorted((a, b) => a.top - b.top);
  return lines.some((line, place) => place > 0 && line.top >= lines[place - 1].bottom - 2);
}

/** @param {Element} select */
export function cutChoice(select) {
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
export function cutValue(input) {
  if (!input.matches("input:is([type=text], [type=number], :not([type]))")) return undefined;
  const lack_px = input.scrollWidth - input.clientWidth;
  const isCut = lack_px > SLACK_PX && getComputedStyle(input).textOverflow !== "ellipsis";
  return isCut ? `${nameOf(input)} cuts “${input.value}” by ${lack_px} px` : undefined;
}

export function sideways() {
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
