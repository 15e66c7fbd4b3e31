/** Name of a picture that came without one, such as a pasted one. */
const NAMELESS = "face";

/** Longer names are cut: file systems allow some 255 bytes, and an ending comes after it. */
const MOST_LETTERS = 80;

/** What file systems refuse in names, and signs that turn the reading direction, so that a name would show another ending. */
const REFUSED = /[<>:"/\\|?*\p{Cc}\u200e\u200f\u202a-\u202e\u2066-\u2069]/gu;

/** Windows keeps these for itself, whatever their ending. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/i;

/** Clipboards and iPhones' cameras call every picture so. */
const SAYS_NOTHING = /^image$/i;

/** Meshes of another density than usual have their number of points at the end of their names. */
const POINTS = /-\d{3,6}$/;

/**
 * A file's name without its ending, fit to name other files by.
 *
 * @param {Blob} file which has a name only if it is a file
 */
export function stemOf(file) {
  const name = file instanceof File ? file.name : "";
  const stem = [...name.replace(/\.[^.]*$/, "").replace(REFUSED, "")].slice(0, MOST_LETTERS).join("");
  const tidy = stem.replace(/^[\s.]+|[\s.]+$/g, "");
  return tidy === "" || RESERVED.test(tidy) || SAYS_NOTHING.test(tidy) ? NAMELESS : tidy;
}

/**
 * The same without the number of points that this page has put there.
 *
 * @param {Blob} file
 */
export function stemOfMesh(file) {
  return stemOf(file).replace(POINTS, "") || NAMELESS;
}

/**
 * How a file made of a face is called.
 *
 * @param {{ name?: string | undefined } | undefined} face
 * @param {string} ending
 * @param {number | string} [apart] what tells it apart in a folder of downloads: the number of points of a mesh that was
 *   subdivided, or what a picture shows
 */
export function fileName(face, ending, apart) {
  const stem = face?.name ?? NAMELESS;
  return apart === undefined ? `${stem}.${ending}` : `${stem}-${apart}.${ending}`;
}
