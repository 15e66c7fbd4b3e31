import { byId } from "../page/dom.js";
import { remember, remembered } from "../page/remember.js";
import { numberPoints } from "../words/names.js";
import { tellAll } from "../words/words.js";

/** Technical display modes. In index.html, `data-expert` marks the other technical controls. */
const DISPLAYS = ["normals", "response", "distortion"];

/** The switch that shows technical controls and point numbers. */
export function setUpExpert() {
  const box = byId("expert", HTMLInputElement);
  for (const display of DISPLAYS) {
    document.querySelector(`#shading label:has([value="${display}"])`)?.setAttribute("data-expert", "");
  }
  const apply = () => {
    document.documentElement.toggleAttribute("data-expert-on", box.checked);
    numberPoints(box.checked);
    tellAll();
  };
  box.checked = remembered("expert") === "on";
  box.addEventListener("change", () => {
    remember("expert", box.checked ? "on" : "off");
    apply();
  });
  apply();
}
