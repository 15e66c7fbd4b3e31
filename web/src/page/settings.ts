import { language, languages, loadWords, onLocaleChange, setLanguage, translatePage } from "../words/words.ts";
import { byId } from "./dom.ts";
import { remember, remembered } from "./remember.ts";

export type Theme = "light" | "dark";

const DARK = matchMedia("(prefers-color-scheme: dark)");

/** Translates the page into the chosen language, else into the first of the browser's that is available. */
export async function setUpLanguage() {
  const chosen = remembered("language");
  await loadWords(...(chosen ? [chosen] : navigator.languages));
  const menu = byId("language", HTMLSelectElement);
  menu.replaceChildren(...languages.map(({ id, name }) => new Option(name, id)));
  menu.value = language();
  menu.addEventListener("change", async () => {
    await setLanguage(menu.value).then(() => remember("language", language()), () => {});
    // The previous one, if the words could not be loaded.
    menu.value = language();
  });
  onLocaleChange(translatePage);
}

/** Follows the system's theme until the user chooses one. */
export function setUpTheme(changed: () => void) {
  const apply = () => {
    document.documentElement.dataset["theme"] = theme();
    changed();
  };
  DARK.addEventListener("change", apply);
  byId("theme", HTMLButtonElement).addEventListener("click", () => {
    remember("theme", theme() === "dark" ? "light" : "dark");
    apply();
  });
  apply();
}

export function theme(): Theme {
  const chosen = remembered("theme");
  return chosen === "light" || chosen === "dark" ? chosen : DARK.matches ? "dark" : "light";
}
