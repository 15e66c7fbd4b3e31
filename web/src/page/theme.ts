import { byId } from "./dom.ts";
import { remember, remembered } from "./remember.ts";

/** Sets up the theme: the system's preference until the user chooses one. */
export function setUpTheme(changed: (theme: "light" | "dark") => void) {
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

function chosen(): "light" | "dark" | undefined {
  const theme = remembered("theme");
  return theme === "light" || theme === "dark" ? theme : undefined;
}
