import { leadPhotoOf } from "./face.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Host } from "../viewport/host.ts";
import type { PhotoType } from "../worker/protocol.ts";
import type { FileOptions } from "../../wasm/rosto-vision-web.js";
import type { Face } from "./face.ts";

/** Name of the files in a zip archive. */
const BUNDLED_NAME = "face";

export type FaceFiles = ReturnType<typeof faceFiles>;

/**
 * Files of the open face, with its current edits. The worker makes them, to keep the main thread responsive. Each
 * method throws `no-face` if no face is open, and `restarting` during a restart.
 */
export function faceFiles(host: Host, vision: VisionClient, opening: { remember: () => Face | undefined }) {
  const open = () => {
    const open = opening.remember();
    if (!open) throw { code: "no-face", message: "no face is open", hint: "" };
    const { photos, edits, pictures, files } = open;
    return { face: { photos, edits, pictures }, files, lead: leadPhotoOf(open) };
  };
  const state = () => host.answer((studio) => studio.state());
  const textureSize = () => state().chosen["texture-size"] ?? "";
  return {
    /**
     * A mesh, or a zip archive if there are companion files.
     *
     * @param format such as "glb"
     */
    mesh: async (format: string, options: FileOptions) => {
      const all = { "texture-size": textureSize(), ...options };
      return vision.request("write", { ...open(), format, options: all, name: BUNDLED_NAME });
    },
    project: async () => vision.request("write-project", open()),
    /** Measures of the body for printing; undefined if only the surface is exported. */
    print: async (options: FileOptions) => vision.request("print", { ...open(), options }),
    /** The lead photo with the edits, upright and in sRGB, without metadata such as its location. */
    editedPhoto: async (mediaType: PhotoType) =>
      vision.request("edited-photo", { ...open(), falloffBand: state().falloffBand, mediaType }),
    /** The whole-face texture. */
    texture: async () => vision.request("texture", { ...open(), size: textureSize() }),
    /** Cancels the files that are being made. */
    cancel: () => vision.cancel(),
    /** Runs the paper's experiment on the face as it was found; undefined if it was stopped. */
    paper: async (report: (share: number) => void) =>
      vision.request("paper", { face: open().face }, (_, share) => report(share)),
    stopPaper: () => {
      vision.request("stop-paper", {}).catch(() => {});
    },
  };
}
