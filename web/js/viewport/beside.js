import { byId } from "../page/dom.js";
import { remember, remembered } from "../page/remember.js";

/** @typedef {import("./host.js").Host} Host */

/** The stage holds both from this width on, in CSS px; stage.css says the same. */
const WIDE = matchMedia("(width >= 1080px)");

/**
 * The photo beside the face in the round, for as long as the window is wide: a press on it puts it on the stage alone.
 *
 * @param {Host} host
 */
export function setUpBeside(host) {
  const button = byId("both", HTMLButtonElement);
  const photo = byId("beside", HTMLButtonElement);
  let isWanted = remembered("beside") === "yes";
  let isPhoto = false;
  const show = () => {
    const isShown = isWanted && WIDE.matches && !isPhoto && document.body.dataset["state"] === "face";
    button.setAttribute("aria-pressed", String(isShown));
    if (photo.hidden !== isShown) return;
    photo.hidden = !isShown;
    document.body.toggleAttribute("data-beside", isShown);
    host.tellPhoto();
  };
  const want = (/** @type {boolean} */ wanted) => {
    isWanted = wanted;
    remember("beside", wanted ? "yes" : "no");
    show();
  };
  button.addEventListener("click", () => {
    const wanted = Boolean(photo.hidden);
    if (wanted) host.act((studio) => studio.choose("scene", "solid"));
    want(wanted);
  });
  photo.addEventListener("click", () => host.act((studio) => studio.choose("scene", "picture")));
  WIDE.addEventListener("change", show);
  host.onChange((state) => {
    isPhoto = state.chosen("scene") === "picture";
    show();
  });
}
