import { byId, isComposing } from "../page/dom.ts";
import { remember, remembered } from "../page/remember.ts";
import type { Host } from "./host.ts";

/** Minimum width for photo and 3D face, in CSS px; same as in stage.css. */
const WIDE_WINDOW = matchMedia("(width >= 1080px)");

/** Pressing the button for longer than this shows the original while it is held, in ms. */
const HOLD_MS = 250;

/** Equals `--wipe-thumb` in stage.css. The thumb's centre stays half its width away from both ends, in CSS px. */
const THUMB_PX = 40;

/**
 * Sets up the views of photo and 3D face, and the body's `data-scene`. If the window is wide enough, both are seen next
 * to each other; a click on the photo opens it on the stage. Else, the photo is behind the 3D face.
 */
export function setUpViews(host: Host) {
  const { dataset } = document.body;
  const button = byId("split-view", HTMLButtonElement);
  const photo = byId("photo-pane", HTMLButtonElement);
  let isWanted = remembered("split-view") !== "no";
  /** The studio that knows where the photo is. */
  let informed: object | undefined;
  const show = () => {
    const isShown = isWanted && WIDE_WINDOW.matches && dataset["scene"] !== "picture" && dataset["state"] === "face";
    button.ariaPressed = String(isShown);
    if (photo.hidden !== isShown && informed === host.instance) return;
    photo.hidden = !isShown;
    informed = host.instance;
    host.apply({ backdrop: !isShown });
    host.updatePhoto();
  };
  button.addEventListener("click", () => {
    isWanted = Boolean(photo.hidden);
    remember("split-view", isWanted ? "yes" : "no");
    if (isWanted) host.apply({ scene: "solid" });
    show();
  });
  for (const picture of [photo, byId("photo-to-stage", HTMLButtonElement)]) {
    picture.addEventListener("click", () => host.apply({ scene: "picture" }));
  }
  WIDE_WINDOW.addEventListener("change", show);
  host.on("change", ({ chosen }) => {
    dataset["scene"] = chosen["scene"] ?? "solid";
    show();
  });
}

/** Compares with the original: B or a long press shows it in full, a click shows both sides of a movable edge. */
export function setUpBeforeAfter(host: Host) {
  const edge = byId("wipe", HTMLInputElement);
  const words = byId("wipe-words", HTMLParagraphElement);
  const button = byId("compare", HTMLButtonElement);
  let timer = 0;
  let wasHeld = false;
  const hold = (held: boolean) => {
    host.apply({ before: held ? 1 : 0 });
    document.body.toggleAttribute("data-comparing", held || !edge.hidden);
  };
  const applyEdge = () => {
    const { offsetLeft, clientWidth } = edge;
    const share = (offsetLeft + THUMB_PX / 2 + edge.valueAsNumber * (clientWidth - THUMB_PX)) / host.canvas.clientWidth;
    words.style.setProperty("--wipe", `${100 * share}%`);
    host.apply({ wipe: edge.hidden ? undefined : share });
  };
  const showEdge = (isShown: boolean) => {
    if (edge.hidden !== isShown) return;
    [edge.hidden, words.hidden, edge.value] = [!isShown, !isShown, "0.5"];
    button.ariaPressed = String(isShown);
    document.body.toggleAttribute("data-comparing", isShown);
    applyEdge();
  };

  edge.addEventListener("input", applyEdge);
  host.on("size", () => edge.hidden || applyEdge());
  // Opening another face ends the comparison.
  host.on("change", ({ isWiping }) => isWiping || showEdge(false));
  addEventListener("keydown", ({ key }) => key === "Escape" && showEdge(false));

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
    if (!wasHeld) showEdge(Boolean(edge.hidden));
    wasHeld = false;
  });
  for (const type of ["keydown", "keyup"] as const) {
    host.canvas.addEventListener(type, (event) => {
      const isElse = event.repeat || event.ctrlKey || event.metaKey || event.altKey || isComposing(event);
      if (event.key.toLowerCase() === "b" && (type === "keyup" || !isElse)) hold(type === "keydown");
    });
  }
  host.canvas.addEventListener("blur", () => hold(false));
}
