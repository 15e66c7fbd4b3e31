import { byId } from "../page/dom.js";

/** @typedef {import("./host.js").Host} Host */

/** A button that is held for longer shows the face before for as long as it is held, in ms. */
const HOLD_MS = 250;

/** As `--wipe-thumb` in stage.css: the handle's middle goes from half of it to half of it before the end, in CSS px. */
const THUMB_PX = 40;

/**
 * The face as it was found: all of it while B or the button is held, or beside the face as it is now, with an edge between
 * them that can be moved.
 *
 * @param {Host} host
 */
export function setUpBeforeAfter(host) {
  const hold = (/** @type {boolean} */ held) => {
    host.act((studio) => studio.setBefore(held ? 1 : 0));
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

/**
 * @param {(held: boolean) => void} hold
 * @param {Wipe} wipe
 */
function setUpButton(hold, wipe) {
  const button = byId("compare", HTMLButtonElement);
  let wait = 0;
  let wasHeld = false;
  button.addEventListener("pointerdown", () => {
    wasHeld = false;
    wait = setTimeout(() => {
      wasHeld = true;
      hold(true);
    }, HOLD_MS);
  });
  for (const end of ["pointerup", "pointerleave", "pointercancel", "blur"]) {
    button.addEventListener(end, () => {
      clearTimeout(wait);
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

/** @typedef {ReturnType<typeof setUpWipe>} Wipe */

/** @param {Host} host */
function setUpWipe(host) {
  const edge = byId("wipe", HTMLInputElement);
  const words = byId("wipe-words", HTMLParagraphElement);
  const button = byId("compare", HTMLButtonElement);
  const apply = () => {
    const width = edge.clientWidth;
    const share = (THUMB_PX / 2 + edge.valueAsNumber * (width - THUMB_PX)) / width;
    words.style.setProperty("--wipe", `${100 * share}%`);
    host.act((studio) => studio.setWipe(edge.hidden ? undefined : share));
  };
  const show = (/** @type {boolean} */ shown) => {
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
  // Another face has come, of which nothing is compared yet.
  host.onChange(({ isWiping }) => {
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
