/**
 * The worker that finds faces and follows them. It holds nothing of the user's: the page may end it at any time and start another.
 *
 * @typedef {import("./protocol.js").Request} Request
 * @typedef {import("./protocol.js").Reply} Reply
 * @typedef {import("./protocol.js").FoundFaces} FoundFaces
 * @typedef {Extract<Request, { type: "load" }>} Place
 */
import init, { checkLength, Vision } from "../../wasm/rosto-vision-web.js";
import { init as setBase } from "../files.js";
import { builtFile, builtModule, vouchFor } from "../page/built.js";
import { asPageError } from "../page/page-error.js";
import { bytesOf } from "../work/bytes.js";
import { bitmapOf } from "../work/pixels.js";
import { decodedByBrowser } from "./browser-decoder.js";
import { drawEdited } from "./edited-photo.js";
import { follow } from "./frames.js";
import { textureOf } from "./texture.js";

const page = /** @type {DedicatedWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/** The lock is held for as long as this worker lives, however it ends: that is how the page notices. */
const lock = `rosto-vision-${crypto.randomUUID()}`;
navigator.locks.request(lock, () => {
  tell({ type: "alive", lock });
  return new Promise(() => {});
});

/** So often, at most, the page hears that something is arriving. */
const TELL_EVERY_MS = 1000;

/** @type {(place: Place) => void} */
let begin = () => {};
/** The page says first of all where the files lie, and what vouches for them. @type {Promise<Place>} */
const told = new Promise((resolve) => (begin = resolve));
const vision = told.then(load);
vision.then(
  () => tell({ type: "ready" }),
  (error) => tell({ type: "unusable", error: asPageError(error, "not-loaded") }),
);

page.addEventListener("message", (event) => take(event.data));

/** @param {Request} request */
function take(request) {
  switch (request.type) {
    case "load":
      return begin(request);
    case "find":
      return answer(request);
    case "draw":
      return answerWithPhoto(request);
    case "texture":
      return answerWithTexture(request);
    case "follow":
      return answerFrame(request);
    case "stop-following":
      // A worker that could not load has said so.
      return vision.then((vision) => vision.stopFollowing(), () => {});
  }
}

/** @param {Place} place */
async function load({ base, list }) {
  if (base !== undefined) setBase(base);
  vouchFor(list);
  const module = new URL("../../wasm/rosto-vision-web_bg.wasm", import.meta.url);
  const first = new URL("../../assets/face_detector.onnx", import.meta.url);
  const second = new URL("../../assets/face_landmarks_attention.onnx", import.meta.url);
  const [module_or_path, detector, landmarks] = await Promise.all([
    builtModule("wasm/rosto-vision-web_bg.wasm", module, tellOfArrival),
    builtFile("assets/face_detector.onnx", first, tellOfArrival),
    builtFile("assets/face_landmarks_attention.onnx", second, tellOfArrival),
  ]);
  await init({ module_or_path });
  return new Vision(new Uint8Array(detector), new Uint8Array(landmarks));
}

/**
 * While a file arrives the page hears of it: a slow connection is not a dead one. Whoever uses the file hears of what goes
 * wrong.
 *
 * @param {Response} answer
 */
function tellOfArrival(answer) {
  readToTell(answer.clone()).catch(() => {});
}

/** @param {Response} response a copy, read to see it come */
async function readToTell(response) {
  const reader = response.body?.getReader();
  let told_ms = -Infinity;
  while (reader && !(await reader.read()).done) {
    if (performance.now() - told_ms < TELL_EVERY_MS) continue;
    told_ms = performance.now();
    tell({ type: "loading" });
  }
}

/** @param {Extract<Request, { type: "find" }>} request */
async function answer({ id, photo, maxFaces }) {
  try {
    const faces = await findDecoded(await vision, photo, maxFaces, id);
    const found = { ...faces, bitmap: await bitmapOf(faces) };
    tell({ type: "found", id, found }, [found.bitmap, ...buffersOf(found)]);
  } catch (error) {
    tellOfFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "draw" }>} request */
async function answerWithPhoto({ id, edited }) {
  try {
    await vision;
    tell({ type: "drawn", id, file: await drawEdited(edited) });
  } catch (error) {
    tellOfFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "texture" }>} request */
async function answerWithTexture({ id, face }) {
  try {
    await vision;
    const pixels = textureOf(face);
    tell({ type: "textured", id, pixels }, [/** @type {ArrayBuffer} */ (pixels.buffer)]);
  } catch (error) {
    tellOfFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "follow" }>} request */
async function answerFrame({ id, frame, time_ms }) {
  try {
    const followed = follow(await vision, frame, time_ms);
    const { landmarks } = followed;
    tell({ type: "followed", id, followed }, landmarks ? [frame, landmarks.buffer] : [frame]);
  } catch (error) {
    frame.close();
    tellOfFailure("not-followed", id, error);
  }
}

/**
 * @param {"failed" | "not-followed"} type
 * @param {number} id
 * @param {unknown} error
 */
function tellOfFailure(type, id, error) {
  // After a trap the module's memory is in an unknown state: the page starts another worker.
  if (error instanceof WebAssembly.RuntimeError) tell({ type: "trapped", id, message: error.message });
  else tell({ type, id, error: asPageError(error) });
}

/**
 * Finds faces in a photo, decoded by the module, or by the browser where the module does not read the format.
 *
 * @param {Vision} vision
 * @param {Blob} photo
 * @param {number} maxFaces
 * @param {number} id
 */
async function findDecoded(vision, photo, maxFaces, id) {
  checkLength(photo.size);
  const bytes = await bytesOf(photo);
  try {
    return find(vision, bytes, maxFaces, id);
  } catch (error) {
    const decoded = asPageError(error).code === "unsupported-format" ? await decodedByBrowser(photo) : undefined;
    if (!decoded) throw error;
    return find(vision, await bytesOf(decoded), maxFaces, id, bytes);
  }
}

/**
 * @param {Vision} vision
 * @param {Uint8Array} bytes
 * @param {number} maxFaces
 * @param {number} id
 * @param {Uint8Array} [original] the file that the browser decoded to these bytes
 * @returns {Omit<FoundFaces, "bitmap">}
 */
function find(vision, bytes, maxFaces, id, original) {
  /** @type {(stage: import("./protocol.js").Stage, fraction: number) => void} */
  const report = (stage, fraction) => tell({ type: "progress", id, stage, fraction });
  const found = vision.find(bytes, maxFaces, report, original);
  try {
    const faces = Array.from({ length: found.faceCount }, (_, i) => ({
      isDoubtful: found.isDoubtful(i),
      landmarks: found.landmarks(i),
      colours: found.colours(i),
    }));
    return {
      width_px: found.width,
      height_px: found.height,
      focalLength_mm: found.focalLength35mm,
      faces,
      pictureWidth_px: found.pictureWidth,
      pictureHeight_px: found.pictureHeight,
      picture: found.takePicture(),
    };
  } finally {
    found.free();
  }
}

/** @param {FoundFaces} found */
function buffersOf(found) {
  const arrays = [found.picture, ...found.faces.flatMap((face) => [face.landmarks, face.colours])];
  return arrays.map((array) => /** @type {ArrayBuffer} */ (array.buffer));
}

/**
 * @param {Reply} reply
 * @param {Transferable[]} [transfer]
 */
function tell(reply, transfer = []) {
  page.postMessage(reply, transfer);
}
