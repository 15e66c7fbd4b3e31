// What overlaps and what is covered. It runs in the page.
import { floats, isSeen, nameOf, overlap, SLACK_PX } from "./basics.mjs";

export function overlapping() {
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
export function lyingOver(box) {
  const panel = document.getElementById("panel");
  return [...floats(), ...(panel && isSeen(panel) ? [panel] : [])]
    .filter((element) => overlap(element, { getBoundingClientRect: () => box }))
    .map(nameOf);
}

/** Controls whose middle something else takes the presses of. @param {Element} scope */
export function covered(scope) {
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

/** @param {Element} scope */
export function controls(scope) {
  const all = scope.querySelectorAll("button, input, select, textarea, summary, a[href], [role=button], [role=tab]");
  return [...all].filter((element) => isSeen(element) && getComputedStyle(element).pointerEvents !== "none");
}

/** Whether a place is within all that scrolls around an element. */
export function reachable(element, x, y) {
  for (let up = element.parentElement; up && up !== document.documentElement; up = up.parentElement) {
    const { overflowX, overflowY } = getComputedStyle(up);
    if (overflowX === "visible" && overflowY === "visible") continue;
    const { left, right, top, bottom } = up.getBoundingClientRect();
    if (x <= left + SLACK_PX || x >= right - SLACK_PX || y <= top + SLACK_PX || y >= bottom - SLACK_PX) return false;
  }
  return x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight;
}
