import { byId } from "../page/dom.ts";
import type { Host } from "./host.ts";

/** Pressing the button for longer than this shows the original while it is held, in ms. */
const HOLD_MS = 250;

/** Equals `--wipe-thumb` in stage.css. The thumb's centre stays half its width away from both ends, in CSS px. */
const THUMB_PX = 40;

/** Compares with the original: B or a long press shows it in full, a click shows both sides of a movable edge. */
export function setUpBeforeAfter(host: Host) {
  const hold = (held: boolean) => {
    host.apply({ before: held ? 1 : 0 });
    document.body.toggleAttribute("data-comparing", held || wipe.isShown);
  };
  const wipe = setUpWipe(host);
  setUpButton(hold, wipe);
  host.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "b" && !event.repeat && !event.ctrlKey && !event.metaKey) hold(true);
  });
  host.canvas.addEventListener("keyup", (event) => {
    if (event.key.toLowerCase() === "b") hold(false);
  });
  host.canvas.addEventListener("blur", () => hold(false));
}

function setUpButton(hold: (held: boolean) => void, wipe: Wipe) {
  const button = byId("compare", HTMLButtonElement);
  let timer = 0;
  let wasHeld = false;
  button.addEventListener("pointerdown", () => {
    wasHeld = false;
    timer = setTimeout(() => {
      wasHeld = true;
      hold(true);
    }, HOLD_MS);
  });
  for (const end of ["pointerup", "pointerleave", "pointercancel", "blur"]) {
    button.addEventListener(end, () => {
      clearTimeout(timer);
      if (wasHeld) hold(false);
    });
  }
  button.addEventListener("click", () => {
    if (!wasHeld) wipe.toggle();
    wasHeld = false;
  });
  addEventListener("keydown", ({ key }) => {
    if (key === "Escape") wipe.end();
  });
}

export type Wipe = ReturnType<typeof setUpWipe>;

function setUpWipe(host: Host) {
  const edge = byId("wipe", HTMLInputElement);
  const words = byId("wipe-words", HTMLParagraphElement);
  const button = byId("compare", HTMLButtonElement);
  const apply = () => {
    const width = edge.clientWidth;
    const share = (THUMB_PX / 2 + edge.valueAsNumber * (width - THUMB_PX)) / width;
    words.style.setProperty("--wipe", `${100 * share}%`);
    host.apply({ wipe: edge.hidden ? undefined : share });
  };
  const show = (shown: boolean) => {
    if (edge.hidden !== shown) return;
    edge.hidden = !shown;
    words.hidden = !shown;
    document.body.toggleAttribute("data-comparing", shown);
    button.setAttribute("aria-pressed", String(shown));
    if (shown) edge.value = "0.5";
    apply();
  };
  edge.addEventListener("input", apply);
  new ResizeObserver(() => {
    if (!edge.hidden) apply();
  }).observe(host.canvas);
  // Opening another face ends the comparison.
  host.on("change", ({ isWiping }) => {
    if (!isWiping) show(false);
  });
  return {
    get isShown() {
      return !edge.hidden;
    },
    toggle: () => show(Boolean(edge.hidden)),
    end: () => show(false),
  };
}
