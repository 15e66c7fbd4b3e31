import { byId, make, makeIcon } from "../page/dom.ts";
import { toast } from "../page/toast.ts";
import { faceBox } from "../photo/face-box.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { photoOf, viewsOf } from "../work/face.ts";
import type { Host,  } from "../viewport/host.ts";
import type { Opening } from "../opening.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Face, FacePhoto } from "../work/face.ts";
import type { State } from "../../wasm/rosto-studio-web.js";

export type Facts = State["photos"][number];

const THUMBNAIL_PX = 40;
/** Side of the thumbnail's crop, as a multiple of the face's size. */
const AROUND_FACE = 1.4;

/** Lists the photos of the open face, reports missing head turns, and adds or removes photos. */
export class PhotosPanel {
  #host;
  #opening;
  #vision;
  #list = byId("photo-list", HTMLUListElement);
  #missingLine = byId("photos-missing", HTMLParagraphElement);
  #add = byId("add-photo", HTMLButtonElement);
  #restore = byId("photo-removed", HTMLDivElement);
  /** Pictures whose rows are shown. */
  #shown = "";
  /** Last removed photo, and the face and its pictures without it. It can be restored while these are open. */
  #removed: { photo: FacePhoto; face: Face; pictures: string; } | undefined;

  constructor(host: Host, opening: Opening, vision: VisionClient) {
    this.#host = host;
    this.#opening = opening;
    this.#vision = vision;
    this.#setUpChooser();
    byId("restore-photo", HTMLButtonElement).addEventListener("click", () => this.#restorePhoto());
    host.onChange((state) => this.#show(state));
    onLocaleChange(() => this.#host.read((state) => this.#show(state)));
  }

  #setUpChooser() {
    const input = byId("further-files", HTMLInputElement);
    this.#add.addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      const files = [...(input.files ?? [])];
      // Clears the input: choosing the same file twice would fire no change event.
      input.value = "";
      if (files.length > 0) this.#change((opening) => opening.addPhotos(files));
    });
  }

  async #change(act: (opening: Opening) => Promise<void>) {
    const before = this.#count();
    await act(this.#opening);
    const n = this.#count();
    if (n !== before) toast(n > 1 ? t("photos.added", { n }) : t("photos.alone"));
  }

  async #remove(picture: string) {
    const { face } = this.#opening;
    if (!face?.pictures.includes(picture)) return;
    const photo = photoOf(face, picture);
    await this.#change((opening) => opening.removePhoto(picture));
    if (this.#opening.face !== face || face.pictures.includes(picture)) return;
    this.#removed = { photo, face, pictures: face.pictures.join() };
    this.#host.read((state) => this.#show(state));
  }

  async #restorePhoto() {
    const { photo } = this.#removed ?? {};
    if (photo) await this.#change((opening) => opening.restorePhoto(photo));
  }

  #count() {
    return this.#opening.face?.pictures.length ?? 0;
  }

  #show({ photos: facts, missingTurns }: State) {
    const { face } = this.#opening;
    const pictures = face?.pictures ?? [];
    this.#missingLine.textContent = missingTurns.map(missingText).join(" ");
    this.#missingLine.hidden = this.#list.hidden = facts.length < 2;
    this.#add.disabled = facts.length >= this.#host.catalogue.maxPhotos;
    if (pictures.length !== facts.length) return;
    const hadFocus = this.#list.contains(document.activeElement);
    if (pictures.join() !== this.#shown) this.#list.replaceChildren(...(face && pictures.length > 1 ? this.#rows(face) : []));
    this.#shown = pictures.join();
    // Moves the focus if its button was removed.
    if (hadFocus && !this.#list.contains(document.activeElement)) this.#add.focus();
    const restoreHadFocus = this.#restore.contains(document.activeElement);
    this.#restore.hidden = this.#removed?.face !== face || this.#removed?.pictures !== this.#shown;
    if (restoreHadFocus && this.#restore.hidden) this.#add.focus();
    for (const [place, row] of [...this.#list.children].entries()) write(row, facts[place]);
  }

  #rows(face: Face) {
    return face.pictures.map((picture) => {
      const row = make("li");
      const canvas = make("canvas");
      canvas.setAttribute("aria-hidden", "true");
      this.#draw(canvas, photoOf(face, picture)).catch((error) => console.warn("cannot draw a thumbnail:", error));
      const remove = make("button", "icon-button");
      remove.type = "button";
      remove.append(makeIcon("close"));
      // A double click would also remove the photo that moves into this row.
      remove.addEventListener("click", ({ detail }) => detail < 2 && this.#remove(picture));
      row.append(canvas, make("span"), remove);
      return row;
    });
  }

  async #draw(canvas: HTMLCanvasElement, photo: FacePhoto) {
    const thumbnail = await this.#thumbnail(photo);
    [canvas.width, canvas.height] = [thumbnail.width, thumbnail.height];
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
    thumbnail.close();
  }

  async #thumbnail({ photos, pictures: [picture = ""], files }: FacePhoto) {
    const [{ landmarks } = { landmarks: new Float32Array() }] = viewsOf(photos);
    const whole = await this.#vision.request("picture", { picture, files });
    const { x, y, side: size } = faceBox(landmarks, whole.width, whole.height);
    const side = Math.max(1, Math.round(AROUND_FACE * size));
    const side_px = Math.round(THUMBNAIL_PX * devicePixelRatio);
    const resize = { resizeWidth: side_px, resizeHeight: side_px, resizeQuality: ("high" as const) };
    const thumbnail = createImageBitmap(whole, Math.round(x - side / 2), Math.round(y - side / 2), side, side, resize);
    return thumbnail.finally(() => whole.close());
  }
}

function write(row: Element, facts: Facts | undefined) {
  const [span, button] = [row.querySelector("span"), row.querySelector("button")];
  if (!facts || !span || !button) return;
  const turn = turnText(facts);
  span.textContent = facts.leads ? t("photos.leads", { turn }) : turn;
  const words = t("photos.remove", { turn });
  button.setAttribute("aria-label", words);
  button.title = words;
}

function turnText({ turn, yawDeg }: Facts) {
  const degrees = Math.round(Math.abs(yawDeg));
  if (turn === "front") return t("photos.turn.front");
  return t(yawDeg > 0 ? "photos.turn.left" : "photos.turn.right", { degrees });
}

/** @param turn head turn that no photo shows */
function missingText(turn: string) {
  if (turn === "front") return t("photos.missing.front");
  return t(turn === "left" ? "photos.missing.left" : "photos.missing.right");
}
