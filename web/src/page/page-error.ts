import type { PageError } from "../worker/protocol.ts";

/**
 * Converts any thrown value into an error with a code.
 *
 * @param code used if the value has none
 */
export function asPageError(thrown: unknown, code: string = "other"): PageError {
  // DOMException has numeric codes.
  if (typeof thrown === "object" && thrown !== null && "code" in thrown && typeof thrown.code === "string") {
    const { message = "", hint = "", maxMm } = (thrown as Partial<PageError>);
    return { code: thrown.code, message, hint, ...(maxMm !== undefined && { maxMm }) };
  }
  return { code, message: String(thrown), hint: "" };
}

/** The error for a photo without a face. */
export function noFace(): PageError {
  return { code: "no-face-found", message: "no face in the photo", hint: "" };
}
