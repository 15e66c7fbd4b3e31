/** Stem for pictures without a name, such as pasted ones. */
const DEFAULT_STEM = "face";

/** Longer stems are truncated: file systems allow 255 bytes in UTF-8, including the suffix and extension. */
const MAX_BYTES = 200;

/** Characters that file systems reject, and bidirectional controls, which can disguise the extension. */
const FORBIDDEN = /[<>:"/\\|?*\p{Cc}\u200e\u200f\u202a-\u202e\u2066-\u2069]/gu;

/** Device names on Windows, reserved with any extension. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/i;

/** Generic name given by clipboards and iPhone cameras. */
const GENERIC = /^image$/i;

/** Vertex count that the page appends to the name of a subdivided mesh. */
const VERTEX_COUNT = /-\d{3,6}$/;

/** A file's name without its extension, sanitised for use in other file names. */
export function stemOf(file: Blob) {
  const name = file instanceof File ? file.name : "";
  const stem = truncated(name.replace(/\.[^.]*$/, "").replace(FORBIDDEN, ""));
  const tidy = stem.replace(/^[\s.]+|[\s.]+$/g, "");
  return tidy === "" || RESERVED.test(tidy) || GENERIC.test(tidy) ? DEFAULT_STEM : tidy;
}

/** The start of a text, cut between characters as readers see them. */
function truncated(text: string) {
  let bytes = 0;
  for (const { segment, index } of new Intl.Segmenter().segment(text)) {
    bytes += new TextEncoder().encode(segment).length;
    if (bytes > MAX_BYTES) return text.slice(0, index);
  }
  return text;
}

/** Like {@link stemOf}, without the vertex count that the page appends on export. */
export function stemOfMesh(file: Blob) {
  return stemOf(file).replace(VERTEX_COUNT, "") || DEFAULT_STEM;
}

/**
 * Name of an exported file.
 *
 * @param extension without the dot
 * @param suffix vertex count of a subdivided mesh, or the content of a picture
 */
export function fileName(face: { name?: string | undefined; } | undefined, extension: string, suffix?: number | string) {
  const stem = face?.name ?? DEFAULT_STEM;
  return suffix === undefined ? `${stem}.${extension}` : `${stem}-${suffix}.${extension}`;
}
