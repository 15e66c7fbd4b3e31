import { byId } from "../../src/dom.ts";
import { remember, remembered } from "./remember.js";

/**
 * Sets up the theme: the system's preference until the user chooses one.
 *
 * @param {(theme: "light" | "dark") => void} changed
 */
export function setUpTheme(changed) {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    const theme = chosen() ?? (system.matches ? "dark" : "light");
    document.documentElement.dataset["theme"] = theme;
    changed(theme);
  };
  system.addEventListener("change", apply);
  byId("theme", HTMLButtonElement).addEventListener("click", () => {
    const now = document.documentElement.dataset["theme"];
    remember("theme", now === "dark" ? "light" : "dark");
    apply();
  });
  apply();
}

/** @returns {"light" | "dark" | undefined} */
function chosen() {
  const theme = remembered("theme");
  return theme === "light" || theme === "dark" ? theme : undefined;
}
