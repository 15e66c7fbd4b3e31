/**
 * What the site has, in the order in which it is read. A page is made of a Markdown file of the repository, or of what a
 * program says of itself.
 *
 * @typedef {object} Page
 * @property {string} name of the file, without its ending
 * @property {string} [title] in the list of pages, where the text's own heading is too long
 * @property {string} [source] the Markdown, from the repository's root
 * @property {string} [data] measurements to append as a table, from the repository's root
 * @property {"command-line" | "python"} [reference] what says it of itself instead
 *
 * @typedef {{ title: string, pages: Page[] }} Group
 */

/** @type {Group[]} */
export const GROUPS = [
  {
    title: "Start",
    pages: [
      { name: "index", title: "Start", source: "docs/start.md" },
      doc("tutorial", "From selfie to print"),
      { name: "readme", title: "Overview", source: "README.md" },
      doc("features", "Features"),
    ],
  },
  {
    title: "How it works",
    pages: [
      doc("maths", "The mathematics"),
      doc("true-face", "A true face"),
      doc("in-the-photo", "The edit in the photo"),
      doc("several-photos", "Several photos"),
      doc("texture", "Texture all round"),
      doc("expressions", "Expressions"),
      doc("following", "A face in a film"),
      doc("mirror", "The mirror"),
    ],
  },
  {
    title: "To build on",
    pages: [
      doc("python", "Many photos, and Python"),
      { name: "command-line", title: "Reference: command line", reference: "command-line" },
      { name: "python-reference", title: "Reference: Python", reference: "python" },
      doc("formats", "File formats"),
      doc("embedding", "In a page of one’s own"),
      doc("publishing", "Publishing the page"),
      ...["laplacian", "mesh", "landmarks", "photo"].map(crate),
      { name: "architecture", title: "Architecture", source: "ARCHITECTURE.md" },
      { name: "contributing", title: "Contributing", source: "CONTRIBUTING.md" },
    ],
  },
  {
    title: "How well it works",
    pages: [
      doc("nothing-is-sent", "Nothing is sent"),
      doc("robustness", "Which faces are found"),
      doc("opens-elsewhere", "Opens elsewhere"),
      doc("accessibility", "Accessibility"),
      doc("torture", "Fuzzing"),
      { ...doc("benchmarks", "Benchmarks"), data: "docs/benchmarks.json" },
    ],
  },
  {
    title: "Besides",
    pages: [
      doc("decisions/0001-sparse-solver", "Decision 1: the solver"),
      doc("decisions/0002-no-wasm-opt", "Decision 2: no wasm-opt"),
      doc("decisions/0003-a-module-for-webgl", "Decision 3: WebGL2"),
      doc("decisions/0004-own-icc-reader", "Decision 4: colour profiles"),
      doc("decisions/0005-layers-of-our-own", "Decision 5: the networks’ layers"),
      doc("decisions/0006-own-exif-reader", "Decision 6: EXIF"),
      doc("citing", "How to cite"),
      { name: "changelog", title: "Changes", source: "CHANGELOG.md" },
      { name: "security", title: "Security", source: "SECURITY.md" },
    ],
  },
];

export const PAGES = GROUPS.flatMap(({ pages }) => pages);

/** @param {string} path below docs/ @param {string} title */
function doc(path, title) {
  return { name: path.split("/").at(-1) ?? path, title, source: `docs/${path}.md` };
}

/** @param {string} name @returns {Page} */
function crate(name) {
  return { name: `crate-${name}`, title: `The crate ${name}`, source: `crates/${name}/README.md` };
}
