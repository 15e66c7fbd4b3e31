import { GROUPS, PAGES } from "./pages.mjs";

/** @typedef {import("./pages.mjs").Page} Page */

/** What a page of the site may load: its own style and pictures. */
const POLICY = "default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'";

/** Where the product itself is published, as seen from the site; "" if that is not known. */
const PRODUCT = process.env["ROSTO_SITE_PAGE"] ?? "";

/**
 * A page around its text.
 *
 * @param {Page} page
 * @param {string} title the text's own
 * @param {string} article HTML
 */
export function whole(page, title, article) {
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="referrer" content="no-referrer">
<title>${escaped(page.name === "index" ? "Rosto: documentation" : `${title} – Rosto`)}</title>
<link rel="icon" href="icon.svg">
<link rel="stylesheet" href="site.css">
<body>
<a class="skip" href="#text">To the text</a>
<header><a class="name" href="index.html"><img src="icon.svg" alt="" width="24" height="24">Rosto</a>
${PRODUCT && `<a href="${escaped(PRODUCT)}">Open the page</a>`}<a class="to-pages" href="#pages">All pages</a></header>
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

/** @param {import("./pages.mjs").Group} group @param {Page} here */
function list({ title, pages }, here) {
  const items = pages.map((page) => `<li>${link(page, page === here ? ' aria-current="page"' : "")}</li>`);
  return `<h2>${escaped(title)}</h2>\n<ul>${items.join("")}</ul>`;
}

/** @param {Page} page */
function neighbours(page) {
  const at = PAGES.indexOf(page);
  const [before, after] = [PAGES[at - 1], PAGES[at + 1]];
  const links = [before && link(before, ' rel="prev"'), after && link(after, ' rel="next"')];
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
