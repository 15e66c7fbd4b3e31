// What a host sends with every file of the page, said once, in the words of each of the usual hosts. The policy is the
// one in the page's text, and what can only be said in a header.

/** Features with a stable name in every engine: browsers complain about names they do not know. The camera is used. */
const PERMISSIONS = "camera=(self), microphone=(), geolocation=(), display-capture=(), fullscreen=()";

const POLICY = /<meta http-equiv="Content-Security-Policy" content="([^"]+)">/;

/**
 * @param {string} page its text
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
    // No name changes with what is in the file: a copy is used only once the host has said that it still holds.
    ["Cache-Control", "no-cache"],
  ];
}

/**
 * The files that tell a host so, by name.
 *
 * @param {string} page its text
 * @returns {Record<string, string>}
 */
export function hostFiles(page) {
  const headers = headersOf(page);
  const each = (/** @type {(name: string, value: string) => string} */ line) => headers.map(([name, value]) => line(name, value)).join("\n");
  const vercel = { headers: [{ source: "/(.*)", headers: headers.map(([key, value]) => ({ key, value })) }] };
  return {
    // Netlify, Cloudflare Pages and others.
    _headers: `/*\n${each((name, value) => `  ${name}: ${value}`)}\n`,
    "vercel.json": `${JSON.stringify(vercel, undefined, 2)}\n`,
    ".htaccess": `<IfModule mod_headers.c>\n${each((name, value) => `  Header always set ${name} "${value}"`)}\n</IfModule>\nAddType application/wasm .wasm\nAddType text/javascript .js\n`,
    "nginx.conf": `# To be included in the location that serves the page.\n${each((name, value) => `add_header ${name} "${value}" always;`)}\n`,
  };
}
