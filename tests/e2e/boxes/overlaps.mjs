// Overlapping and covered elements. Runs in the page.
import { floats, isSeen, nameOf, overlap, SLACK_PX } from "./basics.mjs";
import { cutting, leaving, sideways, spilling } from "./cuts.mjs";

/** @returns {string[]} */
export function lookOver() {
  const modal = document.querySelector("dialog:modal");
  const scope = modal ?? document.body;
  const all = [...scope.querySelectorAll("*")].filter(isSeen);
  const found = [...(modal ? [] : overlapping()), ...leaving(all), ...spilling(all), ...cutting(all), ...covered(scope), ...sideways()];
  return [...new Set(found)].filter(Boolean);
}

export function overlapping() {
  const [stage, panel] = ["stage", "panel"].map((id) => document.getElementById(id));
  const floating = floats();
  const fixed = [panel].filter(isSeen);
  const elements = [...floating, ...fixed];
  const pairs = floating.flatMap((one, place) => elements.slice(place + 1).map((other) => [one, other]));
  return [...pairs, ...fixed.map((one) => [stage, one])].map(([one, other]) => {
    // The landmark's tag may pass below a notice or the progress.
    const isPassing = [one, other].some(({ id }) => id === "landmark-tag") && [one, other].some(({ id }) => id === "notice" || id === "progress");
    if (isPassing || one.contains(other) || other.contains(one)) return undefined;
    const shared = overlap(one.getBoundingClientRect(), other.getBoundingClientRect());
    return shared && `${nameOf(one)} and ${nameOf(other)} overlap by ${shared}`;
  });
}

/** @param {{ left: number, top: number, right: number, bottom: number }} box */
export function lyingOver(box) {
  const elements = [...floats(), document.getElementById("panel")].filter(isSeen);
  return elements.filter((element) => overlap(element.getBoundingClientRect(), box)).map(nameOf);
}

/** Controls whose centre is covered by another element. @param {Element} scope */
export function covered(scope) {
  return controls(scope).map((element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const hit = reachable(element, x, y) ? document.elementFromPoint(x, y) : undefined;
    const own = [element, element.closest("label"), ...(element.labels ?? [])];
    const isFree = !hit || own.some((one) => one?.contains(hit));
    return isFree ? undefined : `${nameOf(element)} is covered by ${nameOf(hit)}`;
  });
}

/** @param {Element} scope */
export function controls(scope) {
  const all = scope.querySelectorAll("button, input, select, textarea, summary, a[href], [role=button], [role=tab]");
  return [...all].filter((element) => isSeen(element) && getComputedStyle(element).pointerEvents !== "none");
}

/** Whether a point is visible in all scroll containers of an element. */
export function reachable(element, x, y) {
  for (let up = element.parentElement; up && up !== document.documentElement; up = up.parentElement) {
    const { overflowX, overflowY } = getComputedStyle(up);
    if (overflowX === "visible" && overflowY === "visible") continue;
    const { left, right, top, bottom } = up.getBoundingClientRect();
    if (x <= left + SLACK_PX || x >= right - SLACK_PX || y <= top + SLACK_PX || y >= bottom - SLACK_PX) return false;
  }
  return x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight;
}
