import { posix } from "node:path";
import { slug } from "github-slugger";
import MarkdownIt from "markdown-it";
import anchors from "markdown-it-anchor";
import maths from "markdown-it-math/temml";

/**
 * @typedef {import("markdown-it").default} Reader
 * @typedef {ReturnType<Reader["parse"]>[number]} Token
 * @typedef {(address: string, kind: "link" | "picture") => string | undefined} Place where an address of the text lies on the
 *   site; nothing if it has no place there
 */

/** Markdown as GitHub reads it: tables, addresses of headings, and equations between `$`, which become MathML. */
export function reader() {
  const markdown = new MarkdownIt({ html: true });
  // What is wide scrolls by itself, by keys too.
  markdown.renderer.rules["table_open"] = () => '<div class="wide" tabindex="0" role="group" aria-label="table"><table>\n';
  markdown.renderer.rules["table_close"] = () => "</table></div>\n";
  return markdown.use(maths).use(anchors, { slugify: slug, tabIndex: false, uniqueSlugStartIndex: 1 });
}

/**
 * A text as HTML, its links and pictures at their places on the site. What has no place there is text, no link.
 *
 * @param {Reader} markdown
 * @param {string} text
 * @param {Place} place
 */
export function html(markdown, text, place) {
  const tokens = markdown.parse(text, {});
  for (const token of everyOf(tokens)) put(token, place);
  for (const inline of tokens) withoutDeadLinks(inline.children ?? []);
  return markdown.renderer.render(tokens, markdown.options, {});
}

/** The text's first heading. @param {string} text */
export function titleOf(text) {
  return (/^# (.+)$/m.exec(text)?.[1] ?? "").replaceAll("`", "");
}

/** Whether an address is one on the web. @param {string} address */
export function isElsewhere(address) {
  return /^[a-z][a-z0-9+.-]*:/i.test(address);
}

/**
 * An address in a text, from the repository's root, and the heading in it.
 *
 * @param {string} source the text's own, from the root
 * @param {string} address
 */
export function resolved(source, address) {
  const [path = "", heading = ""] = address.split("#");
  return { path: path ? posix.normalize(posix.join(posix.dirname(source), path)) : source, heading };
}

/** @param {Token[]} tokens @returns {Token[]} */
function everyOf(tokens) {
  return tokens.flatMap((token) => [token, ...everyOf(token.children ?? [])]);
}

/** @param {Token} token @param {Place} place */
function put(token, place) {
  if (token.type === "html_inline" || token.type === "html_block") {
    token.content = token.content.replaceAll(/ src="([^"]*)"/g, (_, address) => ` src="${place(address, "picture")}"`);
  }
  const attribute = token.type === "link_open" ? "href" : "src";
  const address = token.type === "link_open" || token.type === "image" ? token.attrGet(attribute) : null;
  if (address !== null) token.attrSet(attribute, place(address, token.type === "image" ? "picture" : "link") ?? "");
}

/** @param {Token[]} tokens of one line */
function withoutDeadLinks(tokens) {
  /** @type {boolean[]} */
  const dead = [];
  for (const token of tokens) {
    if (token.type === "link_open") dead.push(token.attrGet("href") === "");
    const isDead = token.type === "link_close" ? dead.pop() : token.type === "link_open" && dead.at(-1);
    if (isDead) token.tag = "span";
    if (isDead && token.type === "link_open") token.attrs = null;
  }
}
