/**
 * An error, as both wasm modules throw it.
 *
 * @typedef {{ code: string, message: string, hint: string, maxMm?: number }} PageError maxMm: the thickest wall
 *   possible, for `too-thick`
 */

/**
 * Messages between the page and its worker. Buffers and bitmaps are transferred, not copied. A request that reads
 * pictures brings their files, so that a restarted worker can decode them again.
 *
 * @typedef {import("../../wasm/rosto-vision-web.js").FaceRequest} FaceRequest
 * @typedef {import("../../wasm/rosto-vision-web.js").FileOptions} FileOptions
 * @typedef {import("../../wasm/rosto-vision-web.js").OpenedFile} OpenedFile
 * @typedef {import("../../wasm/rosto-vision-web.js").SolidFacts} SolidFacts
 * @typedef {import("../../wasm/rosto-vision-web.js").WrittenFile} WrittenFile
 * @typedef {import("../work/face.js").SourceFile} SourceFile
 *
 * @typedef {"decode" | "detect" | "landmarks"} Stage
 *
 * @typedef {object} Opened
 * @property {string} key
 * @property {Blob} file in memory, so that it stays readable
 * @property {OpenedFile} opened
 * @property {ImageBitmap[]} bitmaps the pictures of the first face
 *
 * @typedef {object} FollowedFrame a camera frame and the face in it
 * @property {number} time_ms timestamp from the request
 * @property {Float32Array} [landmarks] 478 × (x/W, y/H, z/W), smoothed over time; absent without a face
 * @property {number} width_px of the frame
 * @property {number} height_px
 * @property {{ read: number, landmarks: number }} took_ms time to read the pixels and to find the landmarks
 * @property {ImageBitmap} frame the frame, transferred back; the caller closes it
 *
 * @typedef {{ type: "picture", picture: string }
 *   | { type: "texture", face: FaceRequest, size: string }
 *   | { type: "write", face: FaceRequest, format: string, options: FileOptions, name: string }
 *   | { type: "write-project", face: FaceRequest }
 *   | { type: "solid-facts", face: FaceRequest, options: FileOptions }
 *   | { type: "edited-photo", face: FaceRequest, lead: LeadPhoto, falloffBand: number, mediaType: PhotoType }} FaceTask
 * @typedef {"image/png" | "image/jpeg"} PhotoType
 * @typedef {{ picture: string, source: SourceFile }} LeadPhoto
 *
 * @typedef {{ type: "open", id: number, key: string, file: Blob }} OpenRequest
 * @typedef {{ type: "follow", id: number, frame: ImageBitmap, time_ms: number }} FollowRequest
 *
 * @typedef {{ type: "load", module: string, detector: string, landmarks: string }
 *   | OpenRequest
 *   | FaceTask & { id: number, files: SourceFile[] }
 *   | FollowRequest
 *   | { type: "stop-following" }} Request
 *
 * @typedef {{ type: "alive", lock: string }
 *   | { type: "loading" }
 *   | { type: "ready" }
 *   | { type: "unusable", error: PageError }
 *   | { type: "progress", id: number, stage: Stage, fraction: number }
 *   | { type: "open" | FaceTask["type"], id: number, answer: any }
 *   | { type: "failed", id: number, error: PageError }
 *   | { type: "followed", id: number, followed: FollowedFrame }
 *   | { type: "not-followed", id: number, error: PageError }
 *   | { type: "trapped", id: number, message: string }} Reply
 */

/** Makes this file a module, for its types. */
export {};
