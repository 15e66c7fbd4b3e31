import { Opening } from "./opening.ts";
import { byId } from "./page/dom.ts";
import { showHints } from "./page/hint.ts";
import { dismissNotices, showError, showNotAdded, showRemark } from "./page/notice.ts";
import { hideProgress, showProgress } from "./page/progress.ts";
import { resetPanel } from "./page/tabs.ts";
import { isTrap } from "./studio-module.ts";
import type { Incoming } from "./opening.ts";
import type { FaceChoice } from "./photo/face-choice.ts";
import type { PhotoOverlay } from "./photo/photo-overlay.ts";
import type { VisionClient } from "./photo/vision-client.ts";
import type { Host } from "./viewport/host.ts";
import type { Autosave } from "./work/autosave.ts";
import type { Face } from "./work/face.ts";
import type { PhotoRemark } from "../wasm/rosto-vision-web.js";

interface Context {
  /** undefined if the browser cannot draw in 3D */
  host: Promise<Host | undefined>;
  vision: VisionClient;
  overlay: PhotoOverlay;
  faceChoice: FaceChoice;
  autosave: Autosave;
  onOpened: (extraction_ms: number | undefined) => void;
}

/** Opens faces on the page, with its panels, notices and autosave. */
export function pageOpening({ host, vision, overlay, faceChoice, autosave, onOpened }: Context) {
  /** Faces whose remarks the user has seen. */
  const seen = new WeakSet<Face>();
  const warn = (error: unknown) => console.warn("cannot show the recent faces:", error);
  const showFaces = () => faceChoice.show(opening.faces, opening.recent).catch(warn);
  const opening = new Opening(host, vision, {
    begun: () => {
      dismissNotices();
      hideProgress();
    },
    progress: showProgress,
    prepare: async ({ face, faces }, picture) => {
      const display = await overlay.prepare(face, picture);
      faceChoice.prepare(faces, picture);
      return display;
    },
    started: (face) => autosave.start(face),
    opened: (incoming) => {
      const { face } = incoming;
      showOpened(incoming, seen.has(face) ? undefined : face.remarks?.[0]);
      seen.add(face);
      showFaces();
      // Fields that were being typed in can be updated again.
      host.then((ready) => ready?.announce());
      onOpened(incoming.extraction_ms);
    },
    photosChanged: () => {
      autosave.save();
      showFaces();
    },
    addedLittle: (name) => showRemark("adds-little", { name }),
    failed: (error, photo) => {
      // The host reports traps.
      if (isTrap(error)) return;
      if (photo === undefined) showError(error);
      else showNotAdded(photo, error);
    },
    ended: (isNewest) => {
      if (isNewest) hideProgress();
      faceChoice.mark(opening.face);
    },
  });
  return opening;
}

function showOpened({ changedElsewhere, ofThisVisit = false }: Incoming, remark: PhotoRemark | undefined) {
  const isIn3d = document.body.dataset["host"] === "open";
  document.body.dataset["state"] = isIn3d ? "face" : "photo";
  byId("welcome", HTMLElement).hidden = true;
  byId("toolbar", HTMLDivElement).hidden = !isIn3d;
  // Collapse the photo to make room for the tools; without a 3D view, keep it open.
  byId("section-photo", HTMLDetailsElement).open = !isIn3d;
  resetPanel(ofThisVisit);
  if (changedElsewhere) showError({ code: "changed-elsewhere", message: "", hint: "" });
  else if (remark) showRemark(remark.id, remark);
  else if (isIn3d) showHints();
}
