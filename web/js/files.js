/** Where the files lie that are fetched while the modules run. @type {URL | undefined} */
let base;

/**
 * Says under which address the folders `wasm`, `assets` and `words` lie. Without it they are looked for beside these modules'
 * own folder. To be called before anything else is; what was fetched by then stays.
 *
 * @param {string | URL} url of the folder, with or without a slash at its end
 */
export function init(url) {
  const folder = new URL(url, location.href);
  if (!folder.pathname.endsWith("/")) folder.pathname += "/";
  base = folder;
}

/** What {@link init} was told, for a worker that is to know it too. */
export function filesBase() {
  return base?.href;
}

/**
 * Where a file lies.
 *
 * @param {string} name such as "words/en.json"
 * @param {URL} usual beside these modules; whoever asks writes it out as bundlers look for it
 */
export function placeOf(name, usual) {
  return base ? new URL(name, base) : usual;
}
