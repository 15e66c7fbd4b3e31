/**
 * The worker that finds and follows faces. It holds no user data, so the page can terminate and restart it at any time.
 *
 * @typedef {import("./protocol.js").Request} Request
 * @typedef {import("./protocol.js").Reply} Reply
 * @typedef {import("./protocol.js").FoundFaces} FoundFaces
 * @typedef {Extract<Request, { type: "load" }>} LoadRequest
 */
import init, { checkLength, Vision } from "../../wasm/rosto-vision-web.js";
import { init as setBase } from "../files.js";
import { verifiedFile, verifiedModule, setListHash } from "../page/integrity.js";
import { asPageError } from "../page/page-error.js";
import { bytesOf } from "../work/bytes.js";
import { bitmapOf } from "../work/pixels.js";
import { decodeWithBrowser } from "./browser-decoder.js";
import { drawEdited } from "./edited-photo.js";
import { follow } from "./frames.js";
import { textureOf } from "./texture.js";

const page = /** @type {DedicatedWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/** Held for the life of this worker. The browser releases it even after a crash, which the page detects. */
const lock = `rosto-vision-${crypto.randomUUID()}`;
navigator.locks.request(lock, () => {
  post({ type: "alive", lock });
  return new Promise(() => {});
});

/** Minimum interval between loading reports. */
const REPORT_EVERY_MS = 1000;

/** @type {(place: LoadRequest) => void} */
let onLoadRequest = () => {};
/** The page's first message, with the base URL and the hash of the integrity list. @type {Promise<LoadRequest>} */
const loadRequest = new Promise((resolve) => (onLoadRequest = resolve));
const vision = loadRequest.then(load);
vision.then(
  () => post({ type: "ready" }),
  (error) => post({ type: "unusable", error: asPageError(error, "not-loaded") }),
);

page.addEventListener("message", (event) => handle(event.data));

/** @param {Request} request */
function handle(request) {
  switch (request.type) {
    case "load":
      return onLoadRequest(request);
    case "find":
      return handleFind(request);
    case "draw":
      return handleDraw(request);
    case "texture":
      return handleTexture(request);
    case "follow":
      return handleFollow(request);
    case "stop-following":
      // A failure to load was already posted as unusable.
      return vision.then((vision) => vision.stopFollowing(), () => {});
  }
}

/** @param {LoadRequest} request */
async function load({ base, list }) {
  if (base !== undefined) setBase(base);
  setListHash(list);
  const module = new URL("../../wasm/rosto-vision-web_bg.wasm", import.meta.url);
  const detectorUrl = new URL("../../assets/face_detector.onnx", import.meta.url);
  const landmarksUrl = new URL("../../assets/face_landmarks_attention.onnx", import.meta.url);
  const [module_or_path, detector, landmarks] = await Promise.all([
    verifiedModule("wasm/rosto-vision-web_bg.wasm", module, reportLoading),
    verifiedFile("assets/face_detector.onnx", detectorUrl, reportLoading),
    verifiedFile("assets/face_landmarks_attention.onnx", landmarksUrl, reportLoading),
  ]);
  await init({ module_or_path });
  return new Vision(new Uint8Array(detector), new Uint8Array(landmarks));
}

/**
 * Reports that a file is arriving, which resets the page's watchdog on a slow connection. Errors surface where the file
 * is used.
 *
 * @param {Response} response
 */
function reportLoading(response) {
  readAndReport(response.clone()).catch(() => {});
}

/** @param {Response} response a copy, read only to observe its progress */
async function readAndReport(response) {
  const reader = response.body?.getReader();
  let reported_ms = -Infinity;
  while (reader && !(await reader.read()).done) {
    if (performance.now() - reported_ms < REPORT_EVERY_MS) continue;
    reported_ms = performance.now();
    post({ type: "loading" });
  }
}

/** @param {Extract<Request, { type: "find" }>} request */
async function handleFind({ id, photo, maxFaces }) {
  try {
    const faces = await findDecoded(await vision, photo, maxFaces, id);
    const found = { ...faces, bitmap: await bitmapOf(faces) };
    post({ type: "found", id, found }, [found.bitmap, ...buffersOf(found)]);
  } catch (error) {
    postFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "draw" }>} request */
async function handleDraw({ id, edited }) {
  try {
    await vision;
    post({ type: "drawn", id, file: await drawEdited(edited) });
  } catch (error) {
    postFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "texture" }>} request */
async function handleTexture({ id, face }) {
  try {
    await vision;
    const pixels = textureOf(face);
    post({ type: "textured", id, pixels }, [/** @type {ArrayBuffer} */ (pixels.buffer)]);
  } catch (error) {
    postFailure("failed", id, error);
  }
}

/** @param {Extract<Request, { type: "follow" }>} request */
async function handleFollow({ id, frame, time_ms }) {
  try {
    const followed = follow(await vision, frame, time_ms);
    const { landmarks } = followed;
    post({ type: "followed", id, followed }, landmarks ? [frame, landmarks.buffer] : [frame]);
  } catch (error) {
    frame.close();
    postFailure("not-followed", id, error);
  }
}

/**
 * @param {"failed" | "not-followed"} type
 * @param {number} id
 * @param {unknown} error
 */
function postFailure(type, id, error) {
  // A trap leaves the module's memory in an undefined state, so the page restarts the worker.
  if (error instanceof WebAssembly.RuntimeError) post({ type: "trapped", id, message: error.message });
  else post({ type, id, error: asPageError(error) });
}

/**
 * Finds faces in a photo. Falls back to the browser's decoder for formats that the module does not read.
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
    const decoded = asPageError(error).code === "unsupported-format" ? await decodeWithBrowser(photo) : undefined;
    if (!decoded) throw error;
    return find(vision, await bytesOf(decoded), maxFaces, id, bytes);
  }
}

/**
 * @param {Vision} vision
 * @param {Uint8Array} bytes
 * @param {number} maxFaces
 * @param {number} id
 * @param {Uint8Array} [original] the original file, if the browser decoded it to `bytes`
 * @returns {Omit<FoundFaces, "bitmap">}
 */
function find(vision, bytes, maxFaces, id, original) {
  /** @type {(stage: import("./protocol.js").Stage, fraction: number) => void} */
  const report = (stage, fraction) => post({ type: "progress", id, stage, fraction });
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
function post(reply, transfer = []) {
  page.postMessage(reply, transfer);
}
