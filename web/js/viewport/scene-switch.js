import { byId, isTyping } from "../page/dom.js";

/** @typedef {import("./workbench.js").Workbench} Workbench */

/**
 * The photo on the stage or the face in the round: P goes from one to the other, wherever the switch itself is out of reach.
 * What is there stands in `data-scene` of the body.
 *
 * @param {Workbench} bench
 */
export function setUpScene(bench) {
  addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "p" || event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
    if (document.body.dataset["state"] === "face" && !document.querySelector("dialog[open]")) toggle(bench);
  });
  byId("photo-to-stage", HTMLButtonElement).addEventListener("click", () => bench.act((studio) => studio.choose("scene", "picture")));
  bench.onChange((state) => {
    document.body.dataset["scene"] = state.chosen("scene") ?? "solid";
  });
}

/** @param {Workbench} bench */
function toggle(bench) {
  const scene = document.body.dataset["scene"] === "picture" ? "solid" : "picture";
  bench.act((studio) => studio.choose("scene", scene));
}
