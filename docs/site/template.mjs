import { GROUPS, PAGES } from "./pages.mjs";

/** @typedef {import("./pages.mjs").Page} Page */

/** Pages may load only the site's style sheet and pictures. */
const POLICY = "default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'";

/** Address of the published app, relative to the site; empty if unknown. */
const APP = process.env["ROSTO_SITE_PAGE"] ?? "";

/**
 * The HTML document of a page.
 *
 * @param {Page} page
 * @param {string} title first heading of the text
 * @param {string} article HTML
 */
export function document(page, title, article) {
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="referrer" content="no-referrer">
<title>${escaped(page.name === "index" ? "Rosto documentation" : `${title} – Rosto`)}</title>
<link rel="icon" href="icon.svg">
<link rel="stylesheet" href="site.css">
<body>
<a class="skip" href="#text">Skip to the text</a>
<header><a class="name" href="index.html"><img src="icon.svg" alt="" width="24" height="24">Rosto</a>
${APP && `<a href="${escaped(APP)}">Open Rosto</a>`}<a class="to-pages" href="#pages">All pages</a></header>
<main id="text" tabindex="-1">
${article}
${neighbours(page)}
</main>
<nav id="pages" aria-label="All pages" tabindex="-1">
${GROUPS.map((group) => list(group, page)).join("\n")}
</nav>
</body>
</html>
`;
}

/** @param {import("./pages.mjs").Group} group @param {Page} current */
function list({ title, pages }, current) {
  const items = pages.map((page) => `<li>${link(page, page === current ? ' aria-current="page"' : "")}</li>`);
  return `<h2>${escaped(title)}</h2>\n<ul>${items.join("")}</ul>`;
}

/** @param {Page} page */
function neighbours(page) {
  const index = PAGES.indexOf(page);
  const [previous, next] = [PAGES[index - 1], PAGES[index + 1]];
  const links = [previous && link(previous, ' rel="prev"'), next && link(next, ' rel="next"')];
  return `<p class="neighbours">${links.filter(Boolean).join(" ")}</p>`;
}

/** @param {Page} page @param {string} attributes */
function link({ name, title = name }, attributes) {
  return `<a href="${name}.html"${attributes}>${escaped(title)}</a>`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
