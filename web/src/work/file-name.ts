/** Stem for pictures without a name, such as pasted ones. */
const DEFAULT_STEM = "face";

/** File systems allow 255 bytes, including what {@link fileName} adds. */
const MAX_BYTES = 160;

/** Characters that file systems reject, and bidirectional controls, which can disguise the extension. */
const FORBIDDEN = /[<>:"/\\|?*\p{Cc}\u200e\u200f\u202a-\u202e\u2066-\u2069]/gu;

/** Device names on Windows, reserved with any extension. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/i;

/** Generic name given by clipboards and iPhone cameras. */
const GENERIC = /^image$/i;

/** Vertex count that the page appends to the name of a subdivided mesh. */
const VERTEX_COUNT = /-\d{3,6}$/;

/** Number of files of this visit by name. */
const counts = new Map<string, number>();

/** A file's name without its extension, sanitised for use in other file names. */
export function stemOf(file: Blob) {
  const name = file instanceof File ? file.name : "";
  const stem = truncated(name.replace(/\.[^.]*$/, "").replace(FORBIDDEN, ""));
  const tidy = stem.replace(/^[\s.]+|[\s.]+$/g, "");
  return tidy === "" || RESERVED.test(tidy) || GENERIC.test(tidy) ? DEFAULT_STEM : tidy;
}

/** Like {@link stemOf}, without the vertex count that the page appends on export. */
export function stemOfMesh(file: Blob) {
  return stemOf(file).replace(VERTEX_COUNT, "") || DEFAULT_STEM;
}

/**
 * Name of an exported file.
 *
 * @param extension without the dot
 * @param content of a file that is not the face itself
 */
export function fileName(face: { name: string } | undefined, extension: string, content?: string) {
  const stem = face?.name ?? DEFAULT_STEM;
  return content === undefined ? `${stem}.${extension}` : `${stem}-${content}.${extension}`;
}

/** Like {@link fileName}, with a number from the second such file on, because each picture or clip differs. */
export function numberedName(face: { name: string } | undefined, extension: string, content: string) {
  const name = fileName(face, extension, content);
  const count = (counts.get(name) ?? 0) + 1;
  counts.set(name, count);
  return count === 1 ? name : fileName(face, extension, `${content}-${count}`);
}

/** The start of a name, cut between characters as people see them. */
function truncated(name: string) {
  let bytes = 0;
  for (const { segment, index } of new Intl.Segmenter().segment(name)) {
    bytes += new TextEncoder().encode(segment).length;
    if (bytes > MAX_BYTES) return name.slice(0, index);
  }
  return name;
}
