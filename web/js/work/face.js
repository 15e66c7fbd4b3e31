import { stemOf, stemOfMesh } from "./file-name.js";

/**
 * @typedef {object} SourceFile a file with the pictures of a face
 * @property {string} key the worker names the file's pictures `KEY/0`, `KEY/1`, …
 * @property {Blob} file
 * @property {"photo" | "saved"} kind a photo, or a GLB or project
 *
 * @typedef {object} Face an opened face. The same object while its photos and edits change.
 * @property {string} name stem of exported file names
 * @property {SourceFile[]} files
 * @property {string} photos the photos of the face in the studio's format, in the order they were added
 * @property {string[]} pictures the picture of each photo
 * @property {number} lead index of the lead photo
 * @property {string} [edits] in the studio's format; absent for a newly found face
 * @property {string} [preferences] settings and view in the studio's format; absent before the face was on the screen
 *
 * @typedef {object} PhotoView
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {Float32Array} landmarks 468 or 478 × (x/W, y/H, z/W), irises last
 *
 * @typedef {Pick<Face, "photos" | "pictures" | "files">} FacePhoto one photo of a face, with its only file
 */

/** Offsets in the bytes of a photo: see docs/formats.md. */
const [WIDTH_AT, HEIGHT_AT, COUNT_AT, LANDMARKS_AT] = [1, 5, 9, 11];
const VERSION = 1;

/**
 * The faces in a file, most prominent first.
 *
 * @param {import("../worker/protocol.js").Opened} opened
 * @param {string} name stem of exported file names
 * @returns {Face[]}
 */
export function facesOf({ key, file, opened: { kind, faces } }, name) {
  const files = [{ key, file, kind }];
  return faces.map(({ photos, edits, pictures, lead }, index) => ({
    ...{ files, photos, pictures, lead, ...(edits !== undefined && { edits }) },
    name: index === 0 ? name : `${name}-${index + 1}`,
  }));
}

/**
 * Name of the face in a file, without the vertex count that the page appends to the names of other densities.
 *
 * @param {Blob} file
 * @param {string | undefined} edits
 * @param {number | undefined} defaultDensity
 */
export function nameIn(file, edits, defaultDensity) {
  const isMesh = file instanceof File && /\.glb$/i.test(file.name);
  const isOther = edits !== undefined && ![undefined, JSON.parse(edits).density].includes(defaultDensity);
  return isMesh && isOther ? stemOfMesh(file) : stemOf(file);
}

/**
 * Removes the edits that apply only to the photo.
 *
 * @param {string} edits
 */
export function withoutPhotoEdit(edits) {
  const { photo_edit: _, ...others } = JSON.parse(edits);
  return JSON.stringify(others);
}

/**
 * Reads the photos of a face. Throws if they are not in the studio's format.
 *
 * @param {string} photos
 * @returns {PhotoView[]}
 */
export function viewsOf(photos) {
  return /** @type {{ observation: string }[]} */ (JSON.parse(photos)).map(({ observation }) => {
    const bytes = Uint8Array.from(atob(observation), (character) => character.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    if (view.getUint8(0) !== VERSION) throw new Error("a photo of another version");
    const coordinates = 3 * view.getUint16(COUNT_AT, true);
    const landmarks = Float32Array.from({ length: coordinates }, (_, at) => view.getFloat32(LANDMARKS_AT + 4 * at, true));
    return { width_px: view.getUint32(WIDTH_AT, true), height_px: view.getUint32(HEIGHT_AT, true), landmarks };
  });
}

/**
 * Landmarks and size of the lead photo.
 *
 * @param {Face} face
 */
export function leadOf({ photos, lead }) {
  const view = viewsOf(photos)[lead];
  if (!view) throw new Error("no lead photo");
  return view;
}

/**
 * Picture of the lead photo, and the file that contains it.
 *
 * @param {Pick<Face, "pictures" | "lead" | "files">} face
 */
export function leadPhotoOf({ pictures, lead, files }) {
  const picture = pictures[lead] ?? "";
  const [source] = filesWith(files, [picture]);
  if (!source) throw new Error("no file of the lead photo");
  return { picture, source };
}

/**
 * One photo of a face.
 *
 * @param {Face} face
 * @param {string} picture
 * @returns {FacePhoto}
 */
export function photoOf({ photos, pictures, files }, picture) {
  const photo = JSON.parse(photos)[pictures.indexOf(picture)];
  return { photos: JSON.stringify([photo]), pictures: [picture], files: filesWith(files, [picture]) };
}

/**
 * The files that contain one of the pictures.
 *
 * @param {SourceFile[]} files
 * @param {string[]} pictures
 */
export function filesWith(files, pictures) {
  return files.filter(({ key }) => pictures.some((picture) => fileKey(picture) === key));
}

/** Key of a picture's file. @param {string} picture */
export function fileKey(picture) {
  return picture.slice(0, picture.lastIndexOf("/"));
}
