import { posix } from "node:path";
import { slug } from "github-slugger";
import MarkdownIt from "markdown-it";
import anchors from "markdown-it-anchor";
import maths from "markdown-it-math/temml";

/**
 * @typedef {import("markdown-it").default} Reader
 * @typedef {ReturnType<Reader["parse"]>[number]} Token
 * @typedef {(address: string, kind: "link" | "picture") => string | undefined} Resolve address on the site for an address in the
 *   text; `undefined` if the site does not have it
 */

/** A parser for GitHub's Markdown: tables, heading anchors, and equations between `$` as MathML. */
export function reader() {
  const markdown = new MarkdownIt({ html: true });
  // Wide tables scroll on their own, also by keyboard.
  markdown.renderer.rules["table_open"] = () => '<div class="wide" tabindex="0" role="group" aria-label="table"><table>\n';
  markdown.renderer.rules["table_close"] = () => "</table></div>\n";
  return markdown.use(maths).use(anchors, { slugify: slug, tabIndex: false, uniqueSlugStartIndex: 1 });
}

/**
 * Renders a text as HTML with the site's addresses. A link to something that the site does not have becomes plain text.
 *
 * @param {Reader} markdown
 * @param {string} text
 * @param {Resolve} resolve
 */
export function html(markdown, text, resolve) {
  const tokens = markdown.parse(text, {});
  for (const token of flattened(tokens)) resolveAddress(token, resolve);
  for (const inline of tokens) removeDeadLinks(inline.children ?? []);
  return markdown.renderer.render(tokens, markdown.options, {});
}

/** The text's first heading. @param {string} text */
export function titleOf(text) {
  return (/^# (.+)$/m.exec(text)?.[1] ?? "").replaceAll("`", "");
}

/** Whether an address has a scheme, such as `https:`. @param {string} address */
export function isElsewhere(address) {
  return /^[a-z][a-z0-9+.-]*:/i.test(address);
}

/**
 * Path from the repository's root, and heading, of an address in a text.
 *
 * @param {string} source path of the text from the root
 * @param {string} address
 */
export function resolved(source, address) {
  const [path = "", heading = ""] = address.split("#");
  return { path: path ? posix.normalize(posix.join(posix.dirname(source), path)) : source, heading };
}

/** @param {Token[]} tokens @returns {Token[]} */
function flattened(tokens) {
  return tokens.flatMap((token) => [token, ...flattened(token.children ?? [])]);
}

/** @param {Token} token @param {Resolve} resolve */
function resolveAddress(token, resolve) {
  if (token.type === "html_inline" || token.type === "html_block") {
    token.content = token.content.replaceAll(/ src="([^"]*)"/g, (_, address) => ` src="${resolve(address, "picture")}"`);
  }
  const attribute = token.type === "link_open" ? "href" : "src";
  const address = token.type === "link_open" || token.type === "image" ? token.attrGet(attribute) : null;
  if (address !== null) token.attrSet(attribute, resolve(address, token.type === "image" ? "picture" : "link") ?? "");
}

/** @param {Token[]} tokens inline tokens of one block */
function removeDeadLinks(tokens) {
  /** @type {boolean[]} */
  const dead = [];
  for (const token of tokens) {
    if (token.type === "link_open") dead.push(token.attrGet("href") === "");
    const isDead = token.type === "link_close" ? dead.pop() : token.type === "link_open" && dead.at(-1);
    if (isDead) token.tag = "span";
    if (isDead && token.type === "link_open") token.attrs = null;
  }
}
