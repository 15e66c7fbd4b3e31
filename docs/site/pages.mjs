/**
 * The pages of the site, in reading order. A page comes from a Markdown file of the repository or from a generated reference.
 *
 * @typedef {object} Page
 * @property {string} name file name without its extension
 * @property {string} [title] short title for the list of pages; by default the name
 * @property {string} [source] Markdown file, relative to the repository's root
 * @property {string} [data] measurements to append as a table, relative to the repository's root
 * @property {"command-line" | "python"} [reference] generator of the text, in place of `source`
 *
 * @typedef {{ title: string, pages: Page[] }} Group
 */

/** @type {Group[]} */
export const GROUPS = [
  {
    title: "Start",
    pages: [
      { name: "index", title: "Choose a path", source: "docs/start.md" },
      { name: "readme", title: "Overview", source: "README.md" },
    ],
  },
  {
    title: "Make",
    pages: [
      doc("make", "Photo, print and AR"),
      doc("formats", "File formats"),
      doc("privacy", "Privacy"),
      doc("accessibility", "Accessibility"),
    ],
  },
  {
    title: "Embed and batch",
    pages: [
      doc("embed", "Embed the element"),
      doc("batch", "Process many photos"),
      { name: "command-line", title: "Command line reference", reference: "command-line" },
      { name: "python-reference", title: "Python reference", reference: "python" },
      doc("publishing", "Publish the page"),
    ],
  },
  {
    title: "Understand",
    pages: [
      doc("maths", "The mathematics"),
      doc("landmarks", "Landmarks"),
      doc("shape", "Shape and size"),
      doc("several-photos", "Several photos"),
      doc("texture", "Texture"),
      doc("expressions", "Expressions"),
      doc("photo-edit", "Photo edits"),
      doc("live-camera", "Live camera"),
    ],
  },
  {
    title: "Accuracy",
    pages: [
      doc("accuracy", "Accuracy and limits"),
      { ...doc("benchmarks", "Benchmarks"), data: "docs/benchmarks.json" },
      doc("citing", "Cite Rosto"),
    ],
  },
  {
    title: "Contribute",
    pages: [
      { name: "contributing", title: "Contributing", source: "CONTRIBUTING.md" },
      doc("glossary", "Glossary"),
      { name: "architecture", title: "Architecture", source: "ARCHITECTURE.md" },
      ...["laplacian", "mesh", "landmarks", "photo"].map(crate),
      doc("fuzzing", "Fuzzing"),
      { name: "security", title: "Security", source: "SECURITY.md" },
      { name: "changelog", title: "Changelog", source: "CHANGELOG.md" },
      doc("decisions/0001-sparse-solver", "Decision 1: sparse solver"),
      doc("decisions/0002-no-wasm-opt", "Decision 2: wasm-opt"),
      doc("decisions/0003-a-module-for-webgl", "Decision 3: WebGL2 module"),
      doc("decisions/0004-own-icc-reader", "Decision 4: colour profiles"),
      doc("decisions/0005-layers-of-our-own", "Decision 5: network layers"),
      doc("decisions/0006-own-exif-reader", "Decision 6: EXIF reader"),
      doc("decisions/0007-own-panel-renderer", "Decision 7: panel renderer"),
    ],
  },
];

export const PAGES = GROUPS.flatMap(({ pages }) => pages);

/** @param {string} path relative to docs/, without extension @param {string} title */
function doc(path, title) {
  return { name: path.split("/").at(-1) ?? path, title, source: `docs/${path}.md` };
}

/** @param {string} name @returns {Page} */
function crate(name) {
  return { name: `crate-${name}`, title: `Crate ${name}`, source: `crates/${name}/README.md` };
}
