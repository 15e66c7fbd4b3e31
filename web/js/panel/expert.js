import { byId } from "../page/dom.js";
import { remember, remembered } from "../page/remember.js";
import { setPointNumbersShown } from "../words/names.js";
import { notifyLocaleChange } from "../words/words.js";

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
    setPointNumbersShown(box.checked);
    notifyLocaleChange();
  };
  box.checked = remembered("expert") === "on";
  box.addEventListener("change", () => {
    remember("expert", box.checked ? "on" : "off");
    apply();
  });
  apply();
}
