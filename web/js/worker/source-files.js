/**
 * Reads photos and saved files for the module.
 *
 * @typedef {import("../../wasm/rosto-vision-web.js").Vision} Vision
 * @typedef {import("./protocol.js").SourceFile} SourceFile
 */
import { checkLength } from "../../wasm/rosto-vision-web.js";
import { asPageError } from "../page/page-error.js";
import { bytesOf } from "../work/bytes.js";
import { filesWith } from "../work/face.js";
import { decodeWithBrowser } from "./browser-decoder.js";

/** Rosto's projects and GLBs are far smaller; larger files are not read into memory. */
const MAX_SAVED_BYTES = 400_000_000;

/** Starts of a GLB and of a project. No photo starts like this. */
const SAVED = /^(glTF|\s*\{)/;
const START_BYTES = 16;

/**
 * Reads a file, if it is not too large.
 *
 * @param {Blob} file
 */
export async function readFile(file) {
  const isSaved = SAVED.test(new TextDecoder().decode(await bytesOf(file.slice(0, START_BYTES))));
  if (!isSaved) checkLength(file.size);
  else if (file.size > MAX_SAVED_BYTES) throw { code: "too-many-bytes", message: `${file.size} bytes`, hint: "" };
  return { bytes: await bytesOf(file), isSaved };
}

/**
 * Decodes a file. Falls back to the browser's decoder for formats that the module does not read.
 *
 * @template T
 * @param {Blob} file
 * @param {Uint8Array} bytes of the file
 * @param {(bytes: Uint8Array, original?: Uint8Array) => T} decode `original`: the file, if the browser decoded it
 * @returns {Promise<T>}
 */
export async function decoded(file, bytes, decode) {
  try {
    return decode(bytes);
  } catch (error) {
    const converted = asPageError(error).code === "unsupported-format" ? await decodeWithBrowser(file) : undefined;
    if (!converted) throw error;
    return decode(await bytesOf(converted), bytes);
  }
}

/**
 * Decodes pictures that the module does not hold: it keeps only the latest, and a restarted worker has none.
 *
 * @param {Vision} vision
 * @param {string[]} pictures
 * @param {SourceFile[]} files
 */
export async function keepPictures(vision, pictures, files) {
  if (pictures.every((picture) => vision.has(picture))) return;
  // All, because keeping one file may drop the pictures of another.
  for (const { key, file } of filesWith(files, pictures)) {
    const { bytes } = await readFile(file);
    await decoded(file, bytes, (readable, original) => vision.keep(key, readable, original));
  }
}
