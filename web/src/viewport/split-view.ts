import { byId } from "../page/dom.ts";
import { remember, remembered } from "../page/remember.ts";
import type { Host } from "./host.ts";

/** Minimum width for both views, in CSS px; same as in stage.css. */
const WIDE_WINDOW = matchMedia("(width >= 1080px)");

/**
 * Sets up the views of photo and 3D face, and the body's `data-scene`. If the window is wide enough, both can be seen
 * next to each other; a click on the photo opens it on the stage.
 */
export function setUpViews(host: Host) {
  const button = byId("split-view", HTMLButtonElement);
  const photo = byId("photo-pane", HTMLButtonElement);
  let isWanted = remembered("split-view") === "yes";
  let isPhoto = false;
  const show = () => {
    const isShown = isWanted && WIDE_WINDOW.matches && !isPhoto && document.body.dataset["state"] === "face";
    button.setAttribute("aria-pressed", String(isShown));
    if (photo.hidden !== isShown) return;
    photo.hidden = !isShown;
    host.updatePhoto();
  };
  const setWanted = (wanted: boolean) => {
    isWanted = wanted;
    remember("split-view", wanted ? "yes" : "no");
    show();
  };
  button.addEventListener("click", () => {
    const wanted = Boolean(photo.hidden);
    if (wanted) host.apply({ scene: "solid" });
    setWanted(wanted);
  });
  for (const picture of [photo, byId("photo-to-stage", HTMLButtonElement)]) {
    picture.addEventListener("click", () => host.apply({ scene: "picture" }));
  }
  WIDE_WINDOW.addEventListener("change", show);
  host.on("change", ({ chosen }) => {
    document.body.dataset["scene"] = chosen["scene"] ?? "solid";
    isPhoto = chosen["scene"] === "picture";
    show();
  });
}
