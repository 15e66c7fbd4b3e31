import { studioModule } from "../viewport/studio-module.js";
import { bytesOf } from "./bytes.js";
import { stemOf, stemOfMesh } from "./file-name.js";
import { pixelsOf } from "./pixels.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("../../wasm/rosto-studio-web.js").ReopenedFace} ReopenedFace
 */

/** As much of a file as tells what it is. */
const START_BYTES = 4096;

/** A project or GLB of ours is far smaller; what is larger is not read into memory. */
const MAX_BYTES = 400_000_000;

/**
 * What a file is by its first bytes. The page's module must have been started.
 *
 * @param {Blob} file
 */
export async function kindOf(file) {
  return studioModule().sniffFile(await bytesOf(file.slice(0, START_BYTES)));
}

/**
 * The work out of a GLB or project that was saved here, and whether another program has changed it since.
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
    const { width: width_px, height: height_px, edits, triangulation, density, changedElsewhere } = reopened;
    const size = { pictureWidth_px: reopened.pictureWidth, pictureHeight_px: reopened.pictureHeight };
    const name = kind === "glb" && density !== studioModule().usualDensity() ? stemOfMesh(file) : stemOf(file);
    const { lens, inPhoto } = reopened;
    const face = { name, width_px, height_px, landmarks: reopened.landmarks(), lens, colours: reopened.colours() };
    const picture = await pictureOf(reopened, kind);
    return { face: { ...face, ...size, picture }, edits, ...(inPhoto !== undefined && { photo: inPhoto }), triangulation, density, changedElsewhere };
  } finally {
    reopened.free();
  }
}

/**
 * @param {ReopenedFace} reopened
 * @param {"glb" | "project"} kind
 */
async function pictureOf(reopened, kind) {
  const { mediaType: type, pictureWidth, pictureHeight } = reopened;
  const bytes = reopened.takePicture();
  if (type === undefined) return bytes;
  try {
    const bitmap = await createImageBitmap(new Blob([/** @type {BlobPart} */ (bytes)], { type }));
    return pixelsOf(bitmap, pictureWidth, pictureHeight, reopened.place());
  } catch (error) {
    throw { code: kind === "glb" ? "damaged-glb" : "bad-project", message: String(error), hint: "" };
  }
}
