// HTTP headers for the files of the page, in the formats of common hosts. The Content-Security-Policy is the page's
// own, plus the directive that only works in a header.

/** Only features that all engines know, as browsers warn about unknown names. */
const PERMISSIONS = "camera=(self), microphone=(), geolocation=(), display-capture=(), fullscreen=()";

const POLICY = /<meta http-equiv="Content-Security-Policy" content="([^"]+)">/;

/**
 * @param {string} page HTML
 * @returns {[name: string, value: string][]}
 */
export function headersOf(page) {
  const policy = POLICY.exec(page)?.[1];
  if (!policy) throw new Error("the page has no Content-Security-Policy");
  return [
    ["Content-Security-Policy", `${policy}; frame-ancestors 'none'`],
    ["Cross-Origin-Opener-Policy", "same-origin"],
    ["Permissions-Policy", PERMISSIONS],
    ["Referrer-Policy", "no-referrer"],
    ["X-Content-Type-Options", "nosniff"],
    // File names contain no hash, so browsers must revalidate cached copies.
    ["Cache-Control", "no-cache"],
  ];
}

/**
 * The configuration files of common hosts, by name.
 *
 * @param {string} page HTML
 * @returns {Record<string, string>}
 */
export function hostFiles(page) {
  const headers = headersOf(page);
  const format = (/** @type {(name: string, value: string) => string} */ line) => headers.map(([name, value]) => line(name, value)).join("\n");
  const vercel = { headers: [{ source: "/(.*)", headers: headers.map(([key, value]) => ({ key, value })) }] };
  return {
    // Netlify, Cloudflare Pages and others.
    _headers: `/*\n${format((name, value) => `  ${name}: ${value}`)}\n`,
    "vercel.json": `${JSON.stringify(vercel, undefined, 2)}\n`,
    ".htaccess": `<IfModule mod_headers.c>\n${format((name, value) => `  Header always set ${name} "${value}"`)}\n</IfModule>\nAddType application/wasm .wasm\nAddType text/javascript .js\n`,
    "nginx.conf": `# Include this in the location block that serves the page.\n${format((name, value) => `add_header ${name} "${value}" always;`)}\n`,
  };
}
