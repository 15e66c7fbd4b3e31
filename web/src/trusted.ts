/** Rejected in drawings: scripts, event handlers and external references. */
const FORBIDDEN_IN_SVG = /<\s*(script|foreignObject)|\son\w+\s*=|href|url\(|javascript:/i;

const RULES = {
  createScriptURL: (address: string) => {
    // Not location.origin, which is "null" in a frame with srcdoc.
    if (new URL(address).origin === self.origin) return address;
    const hint = "Serve the package's files from the page's origin.";
    throw { code: "other-origin", message: `${address} is not on ${self.origin}`, hint };
  },
  createHTML: (text: string) => {
    if (FORBIDDEN_IN_SVG.test(text)) throw new TypeError("the SVG contains scripts or references");
    return text;
  },
};

type Rules = typeof RULES;
const { trustedTypes } = globalThis as { trustedTypes?: { createPolicy: (name: string, rules: Rules) => Rules } };
/** Not exported, so that only these functions use it. */
let policy: Rules | undefined;

/**
 * URL of a script of this page, for a worker. Throws `sandboxed`, `no-policy` or `other-origin` if the page may not
 * start it.
 */
export function scriptUrl(url: URL) {
  if (self.origin === "null") {
    const hint = "Add allow-same-origin to the frame's sandbox.";
    throw { code: "sandboxed", message: "a frame without an origin cannot start workers", hint };
  }
  return trusted().createScriptURL(url.href);
}

/** SVG made by one of the page's modules, as trusted markup. */
export function trustedSvg(svg: string) {
  return trusted().createHTML(svg);
}

/** The page's Trusted Types policy; plain strings in browsers without Trusted Types. */
function trusted() {
  try {
    policy ??= trustedTypes?.createPolicy("rosto", RULES) ?? RULES;
    return policy;
  } catch (error) {
    const hint = `Add "rosto" to trusted-types in the Content-Security-Policy.`;
    throw { code: "no-policy", message: String(error), hint };
  }
}
