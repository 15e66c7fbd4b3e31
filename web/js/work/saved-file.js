import { studioModule } from "../viewport/studio-module.js";
import { bytesOf } from "./bytes.js";
import { stemOf, stemOfMesh } from "./file-name.js";
import { faceFromPhotos } from "./photos.js";
import { pixelsOf } from "./pixels.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("../../wasm/rosto-studio-web.js").ReopenedPhoto} ReopenedPhoto
 */

/** Length of the prefix that identifies the format. */
const PREFIX_BYTES = 4096;

/** Rosto's projects and GLBs are far smaller; larger files are not read into memory. */
const MAX_BYTES = 400_000_000;

/**
 * Detects a file's format from its first bytes. Requires the page's module.
 *
 * @param {Blob} file
 */
export async function kindOf(file) {
  return studioModule().sniffFile(await bytesOf(file.slice(0, PREFIX_BYTES)));
}

/**
 * Reads the work from a GLB or project saved by Rosto. `changedElsewhere` reports whether another program changed the
 * mesh.
 *
 * @param {Blob} file
 * @param {"glb" | "project"} kind
 * @returns {Promise<Work & { changedElsewhere: boolean }>}
 */
export async function readSavedFile(file, kind) {
  if (file.size > MAX_BYTES) throw { code: "too-many-bytes", message: `${file.size} bytes`, hint: "" };
  const bytes = await bytesOf(file);
  const reopened = kind === "glb" ? studioModule().reopenGlb(bytes) : studioModule().reopenProject(bytes);
  try {
    const { edits, triangulation, density, changedElsewhere, inPhoto, leads } = reopened;
    const name = kind === "glb" && density !== studioModule().defaultDensity() ? stemOfMesh(file) : stemOf(file);
    const photos = await Promise.all(reopened.takePhotos().map((photo) => photoOf(photo, kind)));
    const face = faceFromPhotos(photos, leads, name);
    return { face, edits, ...(inPhoto !== undefined && { photo: inPhoto }), triangulation, density, changedElsewhere };
  } finally {
    reopened.free();
  }
}

/**
 * Converts and frees a photo.
 *
 * @param {ReopenedPhoto} reopened
 * @param {"glb" | "project"} kind
 * @returns {Promise<import("./work.js").OpenedFace>}
 */
async function photoOf(reopened, kind) {
  try {
    const { width: width_px, height: height_px, lens, pictureWidth: pictureWidth_px, pictureHeight: pictureHeight_px } = reopened;
    const found = { width_px, height_px, landmarks: reopened.landmarks, lens, colours: reopened.colours };
    return { ...found, pictureWidth_px, pictureHeight_px, picture: await pictureOf(reopened, kind) };
  } finally {
    reopened.free();
  }
}

/**
 * @param {ReopenedPhoto} reopened
 * @param {"glb" | "project"} kind
 */
async function pictureOf(reopened, kind) {
  const { mediaType: type, pictureWidth, pictureHeight } = reopened;
  const bytes = reopened.takePicture();
  if (type === undefined) return bytes;
  try {
    const bitmap = await createImageBitmap(new Blob([/** @type {BlobPart} */ (bytes)], { type }));
    return pixelsOf(bitmap, pictureWidth, pictureHeight, reopened.place);
  } catch (error) {
    throw { code: kind === "glb" ? "damaged-glb" : "bad-project", message: String(error), hint: "" };
  }
}
