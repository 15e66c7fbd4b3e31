/** The Trusted Types policy that the Content-Security-Policy allows; plain strings in browsers without Trusted Types. */
interface Policy {
  createScriptURL: (address: string) => string;
  createHTML: (text: string) => string;
}

/** Rejected in drawings: scripts, event handlers and external references. */
const FORBIDDEN_IN_SVG = /<\s*(script|foreignObject)|\son\w+\s*=|href|url\(|javascript:/i;

const RULES: Policy = {
  createScriptURL: (address) => {
    if (new URL(address).origin !== location.origin) throw new TypeError(`${address} is not a script of this page`);
    return address;
  },
  createHTML: (text) => {
    if (FORBIDDEN_IN_SVG.test(text)) throw new TypeError("the SVG contains scripts or references");
    return text;
  },
};

const { trustedTypes } = globalThis as { trustedTypes?: { createPolicy: (name: string, rules: Policy) => Policy } };
/** Not exported, so that only these functions use it. */
let policy: Policy | undefined;

/** URL of a script of this page, for a worker. */
export function scriptUrl(url: URL) {
  return trusted().createScriptURL(url.href);
}

/** SVG made by one of the page's modules, as trusted markup. */
export function trustedSvg(svg: string) {
  return trusted().createHTML(svg);
}

function trusted() {
  policy ??= trustedTypes?.createPolicy("rosto", RULES) ?? RULES;
  return policy;
}
