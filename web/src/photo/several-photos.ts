import { MAX_EARLIER_PHOTOS } from "../opening.ts";
import { byId, onAction } from "../page/dom.ts";
import { onLocaleChange, t } from "../words/words.ts";
import type { Opening } from "../opening.ts";

/** Dialog that asks if several photos show one person. */
export class SeveralPhotos {
  #dialog = byId("several", HTMLDialogElement);
  #photos: File[] = [];
  /** Number of photos that a face can have, once it is known. */
  #max = Infinity;

  constructor(opening: Opening) {
    opening.maxPhotos.then((max) => {
      this.#max = max;
      this.#write();
    });
    onAction("photos-together", () => opening.openTogether(this.#answered()));
    onAction("photos-each", () => opening.openEach(this.#answered()));
    onAction("cancel-photos", () => this.close());
    onLocaleChange(() => this.#write());
  }

  ask(photos: File[]) {
    this.#photos = photos;
    this.#write();
    if (!this.#dialog.open) this.#dialog.showModal();
  }

  /** Closes the dialog without an answer. */
  close() {
    this.#dialog.close();
  }

  #answered() {
    this.close();
    return this.#photos;
  }

  #write() {
    const n = this.#photos.length;
    byId("several-title", HTMLHeadingElement).textContent = t("several.title", { n });
    const limit = byId("several-limit", HTMLParagraphElement);
    limit.hidden = n <= this.#max;
    limit.textContent = t("several.limit", { photos: this.#max, faces: 1 + MAX_EARLIER_PHOTOS });
  }
}
