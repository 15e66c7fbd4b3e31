// HTTP headers for the files of the page, in the formats of common hosts. The Content-Security-Policy is the page's
// own, plus the directive that only works in a header.

/** Only features that all engines know, as browsers warn about unknown names. */
const PERMISSIONS = "camera=(self), microphone=(), geolocation=(), display-capture=(), fullscreen=()";

const POLICY = /<meta http-equiv="Content-Security-Policy" content="([^"]+)">/;

/** Folder of a version; its files never change. */
const VERSION = "[0-9a-f]{16}";

/** Browsers ask before they reuse a copy of the page, and keep the files of a version. */
const REVALIDATE = "no-cache";
const IMMUTABLE = "public, max-age=31536000, immutable";

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
  ];
}

/**
 * The configuration files of common hosts, by name.
 *
 * @param {string} page HTML
 * @param {string} version
 * @returns {Record<string, string>}
 */
export function hostFiles(page, version) {
  const headers = headersOf(page);
  /** @param {(header: [name: string, value: string]) => string} line */
  const format = (line) => headers.map(line).join("\n");
  const rule = (source, all) => ({ source, headers: all.map(([key, value]) => ({ key, value })) });
  const revalidated = rule("/(.*)", [...headers, ["Cache-Control", REVALIDATE]]);
  const immutable = rule(`/${version}/(.*)`, [["Cache-Control", IMMUTABLE]]);
  const cache = (pattern, value) => `${pattern}\n  Cache-Control: ${value}\n`;
  const pages = ["/", "/index.html", "/service-worker.js"].map((name) => cache(name, REVALIDATE));
  return {
    // Netlify, Cloudflare Pages and others.
    _headers: ["/*\n", format(([name, value]) => `  ${name}: ${value}`), "\n", ...pages, cache(`/${version}/*`, IMMUTABLE)].join(""),
    "vercel.json": `${JSON.stringify({ headers: [revalidated, immutable] }, undefined, 2)}\n`,
    ".htaccess": [
      "<IfModule mod_headers.c>",
      format(([name, value]) => `  Header always set ${name} "${value}"`),
      `  Header always set Cache-Control "${REVALIDATE}"`,
      `  Header always set Cache-Control "${IMMUTABLE}" "expr=%{REQUEST_URI} =~ m#/${VERSION}/#"`,
      "</IfModule>",
      "AddType application/wasm .wasm",
      "AddType text/javascript .js",
      "",
    ].join("\n"),
    "nginx.conf": [
      "# Include this in the location block that serves the page.",
      `set $rosto_cache "${REVALIDATE}";`,
      `if ($uri ~ "/${VERSION}/") { set $rosto_cache "${IMMUTABLE}"; }`,
      format(([name, value]) => `add_header ${name} "${value}" always;`),
      "add_header Cache-Control $rosto_cache always;",
      "",
    ].join("\n"),
  };
}
