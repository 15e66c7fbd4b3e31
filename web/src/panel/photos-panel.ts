import { byId, make, makeIcon } from "../page/dom.ts";
import { toast } from "../page/toast.ts";
import { faceThumbnail } from "../photo/face-box.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { photoOf, viewsOf } from "../work/face.ts";
import { textOf } from "./phrase.ts";
import type { Opening } from "../opening.ts";
import type { VisionClient } from "../photo/vision-client.ts";
import type { Host } from "../viewport/host.ts";
import type { Face, FacePhoto } from "../work/face.ts";
import type { State } from "../../wasm/rosto-studio-web.js";

const THUMBNAIL_PX = 40;
/** Side of the thumbnail's crop, as a multiple of the face's size. */
const AROUND_FACE = 1.4;

/** Lists the photos of the open face, reports missing head turns, and adds or removes photos. */
export function setUpPhotos(host: Host, opening: Opening, vision: VisionClient) {
  const list = byId("photo-list", HTMLUListElement);
  const missing = byId("photos-missing", HTMLParagraphElement);
  const add = byId("add-photo", HTMLButtonElement);
  const restore = byId("photo-removed", HTMLDivElement);
  /** Pictures whose rows are shown. */
  let shown = "";
  /** Last removed photo, and the face and its pictures without it. It can be restored while these are open. */
  let removed: { photo: FacePhoto; face: Face; pictures: string } | undefined;

  const show = ({ photos, missingTurns }: State) => {
    const { face } = opening;
    const pictures = face?.pictures ?? [];
    missing.textContent = missingTurns.map((turn) => textOf({ key: `photos.missing.${turn}`, values: [] })).join(" ");
    missing.hidden = list.hidden = photos.length < 2;
    add.disabled = photos.length >= host.catalogue.maxPhotos;
    if (!face || pictures.length !== photos.length) return;
    const focused = [list, restore].find((part) => part.contains(document.activeElement));
    const listed = pictures.length > 1 ? pictures : [];
    if (pictures.join() !== shown) list.replaceChildren(...listed.map((picture) => row(face, picture)));
    shown = pictures.join();
    restore.hidden = removed?.face !== face || removed.pictures !== shown;
    if (focused && (focused.hidden || !focused.contains(document.activeElement))) (add.checkVisibility() ? add : byId("photo-change", HTMLButtonElement)).focus();
    for (const [index, photo] of photos.entries()) {
      const [, label, button] = list.children[index]?.children ?? [];
      const turn = turnText(photo);
      if (label) label.textContent = photo.leads ? t("photos.leads", { turn }) : turn;
      if (button instanceof HTMLElement) button.ariaLabel = button.title = t("photos.remove", { turn });
    }
  };
  const row = (face: Face, picture: string) => {
    const [canvas, button] = [make("canvas"), make("button", "icon-button", makeIcon("close"))];
    canvas.ariaHidden = "true";
    drawThumbnail(canvas, photoOf(face, picture)).catch((error) => console.warn("cannot draw a thumbnail:", error));
    button.type = "button";
    // A double click would also remove the photo that moves into this row.
    button.addEventListener("click", ({ detail }) => detail < 2 && remove(picture));
    return make("li", "", canvas, make("span"), button);
  };
  const drawThumbnail = async (canvas: HTMLCanvasElement, { photos, pictures: [picture = ""], files }: FacePhoto) => {
    const whole = await vision.request("picture", { picture, files });
    const [{ landmarks } = { landmarks: new Float32Array() }] = viewsOf(photos);
    const thumbnail = await faceThumbnail(whole, landmarks, AROUND_FACE, THUMBNAIL_PX).finally(() => whole.close());
    canvas.width = canvas.height = thumbnail.width;
    canvas.getContext("2d")?.drawImage(thumbnail, 0, 0);
    thumbnail.close();
  };
  const count = () => opening.face?.pictures.length ?? 0;
  const change = async (act: () => Promise<void>) => {
    const before = count();
    await act();
    const n = count();
    if (n !== before) toast(n > 1 ? t("photos.added", { n }) : t("photos.alone"));
  };
  const remove = async (picture: string) => {
    const { face } = opening;
    if (!face?.pictures.includes(picture)) return;
    const photo = photoOf(face, picture);
    await change(() => opening.removePhoto(picture));
    if (opening.face !== face || face.pictures.includes(picture)) return;
    removed = { photo, face, pictures: face.pictures.join() };
    host.read(show);
  };
  const input = byId("further-files", HTMLInputElement);
  add.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    const files = [...(input.files ?? [])];
    // Choosing the same file twice would fire no change event.
    input.value = "";
    change(() => opening.addPhotos(files));
  });
  byId("restore-photo", HTMLButtonElement).addEventListener("click", () => {
    const { photo } = removed ?? {};
    if (photo) change(() => opening.restorePhoto(photo));
  });
  host.on("change", show);
  onLocaleChange(() => host.read(show));
}

/** Direction of the head in a photo. */
function turnText({ turn, yawDeg }: State["photos"][number]) {
  if (turn === "front") return t("photos.turn.front");
  return t(yawDeg > 0 ? "photos.turn.left" : "photos.turn.right", { degrees: Math.round(Math.abs(yawDeg)) });
}
