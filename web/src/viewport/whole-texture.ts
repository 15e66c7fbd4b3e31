import { asPageError } from "../page/page-error.ts";
import { nextTask } from "../page/tasks.ts";
import type { Host } from "./host.ts";
import type { FaceFiles } from "../work/face-files.ts";

/**
 * Requests the whole-face texture of the open face from the worker, one at a time. Until it exists, the studio shows the
 * photo.
 */
export function followTexture(host: Host, files: FaceFiles, onProgress: (isMaking: boolean) => void = () => {}) {
  let isMaking = false;
  /** The request that failed last. */
  let failed: number | undefined;
  /** The request to be answered. */
  const wanted = () => {
    const request = host.ask((studio) => studio.textureWanted());
    return request === failed ? undefined : request;
  };
  const make = async (request: number) => {
    const { instance } = host;
    try {
      // Draw the face first.
      await nextTask();
      const bitmap = await files.texture();
      if (instance === host.instance) host.perform((studio) => studio.setTexture(request, bitmap));
      else bitmap.close();
      if (wanted() === request) failed = request;
    } catch (error) {
      // Without a texture, the photo stays visible. A file that needs it reports the error. The same request would fail
      // again, unless it was cancelled with others.
      if (instance === host.instance && asPageError(error).code !== "cancelled") failed = request;
    }
  };
  host.on("change", async () => {
    if (isMaking || wanted() === undefined) return;
    isMaking = true;
    onProgress(true);
    for (let request = wanted(); request !== undefined; request = wanted()) await make(request);
    isMaking = false;
    onProgress(false);
  });
  // A restarted studio counts its requests from the start.
  host.onRestart(async () => {
    failed = undefined;
  });
}
