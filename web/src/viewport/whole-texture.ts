import { nextTask } from "../page/tasks.ts";
import type { Host } from "./host.ts";
import type { FaceFiles } from "../work/face-files.ts";

/**
 * Requests the whole-face texture of the open face from the worker, one at a time. Until it exists, the studio shows the
 * photo.
 */
export class WholeTexture {
  #host;
  #files;
  #onProgress;
  #isMaking = false;
  /** The request that failed last. */
  #failed: number | undefined;

  constructor(host: Host, files: FaceFiles, onProgress: (isMaking: boolean) => void = () => {}) {
    this.#host = host;
    this.#files = files;
    this.#onProgress = onProgress;
    host.onChange(() => this.#follow());
    // A restarted studio counts its requests from the start.
    host.onRestart(async () => {
      this.#failed = undefined;
    });
  }

  async #follow() {
    if (this.#isMaking || this.#wanted() === undefined) return;
    this.#isMaking = true;
    this.#onProgress(true);
    for (let wanted = this.#wanted(); wanted !== undefined; wanted = this.#wanted()) {
      const { instance } = this.#host;
      // Without a texture, the photo stays visible. A file that needs it reports the error.
      await this.#make(wanted).catch(() => {});
      // Repeating the request would fail again.
      if (this.#host.instance === instance && this.#wanted() === wanted) this.#failed = wanted;
    }
    this.#isMaking = false;
    this.#onProgress(false);
  }

  /** The request to be answered. */
  #wanted() {
    const wanted = this.#host.ask((studio) => studio.textureWanted());
    return wanted === this.#failed ? undefined : wanted;
  }

  async #make(wanted: number) {
    // Draw the face first.
    await nextTask();
    const { instance } = this.#host;
    const bitmap = await this.#files.texture();
    if (instance === this.#host.instance) this.#host.perform((studio) => studio.setTexture(wanted, bitmap));
    else bitmap.close();
  }
}
