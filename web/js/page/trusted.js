/**
 * The one policy that the page's Content-Security-Policy knows: what becomes a script or markup passes through here, and a
 * browser with Trusted Types refuses whatever does not. Others take the same strings as they are.
 *
 * @typedef {{ createScriptURL: (address: string) => string, createHTML: (text: string) => string }} Policy
 * @typedef {{ createPolicy: (name: string, rules: Policy) => Policy }} PolicyFactory
 */

/** The page's folder. */
const HERE = new URL("../../", import.meta.url);

/** All that is ever started as a script of its own. */
const SCRIPTS = ["js/worker/vision-worker.js", "js/worker/validator-worker.js", "service-worker.js"];

/** What a drawing has no use for: scripts, handlers of events, and addresses of anything else. */
const NO_DRAWING = /<\s*(script|foreignObject)|\son\w+\s*=|href|url\(|javascript:/i;

/** @type {Policy} */
const RULES = {
  createScriptURL: (address) => {
    if (!SCRIPTS.some((name) => new URL(name, HERE).href === address)) throw new TypeError(`${address} is no script of this page`);
    return address;
  },
  createHTML: (text) => {
    if (NO_DRAWING.test(text)) throw new TypeError("this is more than a drawing");
    return text;
  },
};

const { trustedTypes } = /** @type {{ trustedTypes?: PolicyFactory }} */ (globalThis);
const policy = trustedTypes?.createPolicy("rosto", RULES) ?? RULES;

/**
 * The address of a script of the page's.
 *
 * @param {string} name from the page's folder on
 */
export function ownScript(name) {
  return policy.createScriptURL(new URL(name, HERE).href);
}

/**
 * A drawing that one of the page's modules made.
 *
 * @param {string} svg
 */
export function ownDrawing(svg) {
  return policy.createHTML(svg);
}
