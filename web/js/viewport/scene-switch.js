import { byId, isTyping } from "../page/dom.js";

/** @typedef {import("./host.js").Host} Host */

/**
 * The photo on the stage or the face in the round: P goes from one to the other, wherever the switch itself is out of reach.
 * What is there stands in `data-scene` of the body.
 *
 * @param {Host} host
 */
export function setUpScene(host) {
  addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "p" || event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
    if (document.body.dataset["state"] === "face" && !document.querySelector("dialog[open]")) toggle(host);
  });
  byId("photo-to-stage", HTMLButtonElement).addEventListener("click", () => host.act((studio) => studio.choose("scene", "picture")));
  host.onChange((state) => {
    document.body.dataset["scene"] = state.chosen("scene") ?? "solid";
  });
}

/** @param {Host} host */
function toggle(host) {
  const scene = document.body.dataset["scene"] === "picture" ? "solid" : "picture";
  host.act((studio) => studio.choose("scene", scene));
}
