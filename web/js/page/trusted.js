/**
 * The Trusted Types policy that the Content-Security-Policy allows. Script URLs and markup pass through it; browsers
 * without Trusted Types get the same checks and plain strings.
 *
 * @typedef {{ createScriptURL: (address: string) => string, createHTML: (text: string) => string }} Policy
 * @typedef {{ createPolicy: (name: string, rules: Policy) => Policy }} PolicyFactory
 */

/** The page's folder. */
const BASE = new URL("../../", import.meta.url);

/** Scripts of workers and of the service worker. */
const SCRIPTS = ["js/worker/vision-worker.js", "js/worker/validator-worker.js", "service-worker.js"];

/** Rejected in drawings: scripts, event handlers and external references. */
const FORBIDDEN_IN_SVG = /<\s*(script|foreignObject)|\son\w+\s*=|href|url\(|javascript:/i;

/** @type {Policy} */
const RULES = {
  createScriptURL: (address) => {
    if (!SCRIPTS.some((name) => new URL(name, BASE).href === address)) throw new TypeError(`${address} is not a script of this page`);
    return address;
  },
  createHTML: (text) => {
    if (FORBIDDEN_IN_SVG.test(text)) throw new TypeError("the SVG contains scripts or references");
    return text;
  },
};

const { trustedTypes } = /** @type {{ trustedTypes?: PolicyFactory }} */ (globalThis);
const policy = trustedTypes?.createPolicy("rosto", RULES) ?? RULES;

/**
 * URL of one of the page's scripts.
 *
 * @param {string} name path relative to the page's folder
 */
export function scriptUrl(name) {
  return policy.createScriptURL(new URL(name, BASE).href);
}

/**
 * SVG made by one of the page's modules, as trusted markup.
 *
 * @param {string} svg
 */
export function trustedSvg(svg) {
  return policy.createHTML(svg);
}
