/**
 * What went wrong, in the form in which both wasm modules throw it.
 *
 * @typedef {{ code: string, message: string, hint: string }} PageError
 */

/**
 * What the page and its worker say to each other. Buffers and bitmaps are transferred, none is copied.
 *
 * @typedef {"decode" | "detect" | "landmarks"} Stage
 *
 * @typedef {object} FoundFace
 * @property {boolean} isDoubtful it may not be a face
 * @property {Float32Array} landmarks 478 × (x/W, y/H, z/W), MediaPipe's normalised convention; those of the irises last
 * @property {Uint8Array} colours 468 × sRGB
 *
 * @typedef {object} FoundFaces
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {number | undefined} focalLength_mm of the lens for a frame of 36 × 24 mm, if the photo says so
 * @property {FoundFace[]} faces best first; empty when there is no face
 * @property {number} pictureWidth_px of the picture, which may be a smaller copy of the photo
 * @property {number} pictureHeight_px
 * @property {Uint8Array} picture RGBA, upright, row by row
 * @property {ImageBitmap} bitmap the same picture, ready to be drawn
 *
 * @typedef {object} Followed a frame of a film, and the face in it
 * @property {number} time_ms when it was taken, as it was said
 * @property {Float32Array} [landmarks] as those of a face in a photo, smoothed over time; none where there is no face
 * @property {number} width_px of the frame
 * @property {number} height_px
 * @property {{ read: number, landmarks: number }} took_ms what the worker spent on its pixels and on finding the landmarks
 * @property {ImageBitmap} frame that the landmarks belong to, sent back; whoever is given it closes it
 *
 * @typedef {object} Edited a photo to be drawn with what was edited in it
 * @property {Blob} photo the file as it was opened
 * @property {number} width_px of the upright photo that the places are in
 * @property {Float64Array} from_px where its places are, x and y in turn
 * @property {Float64Array} to_px where they go
 * @property {Uint32Array} triangles three places each
 * @property {"image/png" | "image/jpeg"} format
 *
 * @typedef {object} Untextured a face whose texture is to be made
 * @property {Uint8Array} plan as the studio tells it
 * @property {{ pixels: Uint8Array, width_px: number, height_px: number }[]} pictures RGBA, the photos of the plan in its order
 * @property {number} side_px of the texture
 *
 * @typedef {{ type: "load", base: string | undefined, list: string }
 *   | { type: "find", id: number, photo: Blob, maxFaces: number }
 *   | { type: "draw", id: number, edited: Edited }
 *   | { type: "texture", id: number, face: Untextured }
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
 *   | { type: "followed", id: number, followed: Followed }
 *   | { type: "not-followed", id: number, error: PageError }
 *   | { type: "trapped", id: number, message: string }} Reply
 */

/**
 * What the validator says of a file: how many of each.
 *
 * @typedef {{ errors: number, warnings: number, remarks: number }} Verdict
 */

/** Lets this file be imported for its types alone. */
export {};
