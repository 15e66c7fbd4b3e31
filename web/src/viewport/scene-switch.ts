import { byId, isTyping } from "../page/dom.ts";
import type { Host } from "./host.ts";

/**
 * Switches the stage between photo and 3D face by the P key or the photo's thumbnail. Sets the body's `data-scene`.
 */
export function setUpScene(host: Host) {
  addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "p" || event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) return;
    if (document.body.dataset["state"] === "face" && !document.querySelector("dialog[open]")) toggle(host);
  });
  byId("photo-to-stage", HTMLButtonElement).addEventListener("click", () => host.apply({ scene: "picture" }));
  host.onChange(({ chosen }) => {
    document.body.dataset["scene"] = chosen["scene"] ?? "solid";
  });
}

function toggle(host: Host) {
  const scene = document.body.dataset["scene"] === "picture" ? "solid" : "picture";
  host.apply({ scene });
}
