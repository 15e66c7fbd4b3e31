/**
 * An error, as both wasm modules throw it.
 *
 * @typedef {{ code: string, message: string, hint: string }} PageError
 */

/**
 * Messages between the page and its worker. Buffers and bitmaps are transferred, not copied.
 *
 * @typedef {"decode" | "detect" | "landmarks"} Stage
 *
 * @typedef {object} FoundFace
 * @property {boolean} isDoubtful possibly not a face
 * @property {Float32Array} landmarks 478 × (x/W, y/H, z/W), MediaPipe's normalised convention, irises last
 * @property {Uint8Array} colours 468 × sRGB
 *
 * @typedef {object} FoundFaces
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {number | undefined} focalLength_mm 35 mm equivalent from the photo's metadata
 * @property {FoundFace[]} faces most prominent first; empty without a face
 * @property {number} pictureWidth_px of the picture, which may be a smaller copy of the photo
 * @property {number} pictureHeight_px
 * @property {Uint8Array} picture RGBA, upright, row by row
 * @property {ImageBitmap} bitmap the same picture
 *
 * @typedef {object} FollowedFrame a camera frame and the face in it
 * @property {number} time_ms timestamp from the request
 * @property {Float32Array} [landmarks] as in {@link FoundFace}, smoothed over time; absent without a face
 * @property {number} width_px of the frame
 * @property {number} height_px
 * @property {{ read: number, landmarks: number }} took_ms time to read the pixels and to find the landmarks
 * @property {ImageBitmap} frame the frame, transferred back; the caller closes it
 *
 * @typedef {object} PhotoEdit a photo to be drawn with the edits, as a warp mesh
 * @property {Blob} photo the original file
 * @property {number} width_px of the upright photo
 * @property {Float64Array} from_px vertices in the photo, (x, y) pairs
 * @property {Float64Array} to_px their new positions
 * @property {Uint32Array} triangles vertex indices
 * @property {"image/png" | "image/jpeg"} format
 *
 * @typedef {object} TextureTask a face whose texture is to be made
 * @property {Uint8Array} plan in the studio's format
 * @property {{ pixels: Uint8Array, width_px: number, height_px: number }[]} pictures RGBA, in the order of the plan
 * @property {number} side_px of the texture
 *
 * @typedef {{ type: "load", base: string | undefined, list: string }
 *   | { type: "find", id: number, photo: Blob, maxFaces: number }
 *   | { type: "draw", id: number, edited: PhotoEdit }
 *   | { type: "texture", id: number, face: TextureTask }
 *   | { type: "follow", id: number, frame: ImageBitmap, time_ms: number }
 *   | { type: "stop-following" }} Request
 *
 * @typedef {{ type: "alive", lock: string }
 *   | { type: "loading" }
 *   | { type: "ready" }
 *   | { type: "unusable", error: PageError }
 *   | { type: "progress", id: number, stage: Stage, fraction: number }
 *   | { type: "found", id: number, found: FoundFaces }
 *   | { type: "failed", id: number, error: PageError }
 *   | { type: "drawn", id: number, file: Blob }
 *   | { type: "textured", id: number, pixels: Uint8Array }
 *   | { type: "followed", id: number, followed: FollowedFrame }
 *   | { type: "not-followed", id: number, error: PageError }
 *   | { type: "trapped", id: number, message: string }} Reply
 */

/**
 * The validator's number of issues of each severity.
 *
 * @typedef {{ errors: number, warnings: number, remarks: number }} Verdict
 */

/** Makes this file a module, for its types. */
export {};
