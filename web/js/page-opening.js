import { byId } from "../src/dom.ts";
import { showHints } from "./page/hint.js";
import { dismissNotices, showError, showNotAdded, showRemark } from "./page/notice.js";
import { hideProgress, showLoading, showStage } from "./page/progress.js";
import { resetPanel } from "./page/reset-panel.js";
import { isTrap } from "../src/studio-module.ts";
import { Opening } from "./opening.js";
import { recentFaces } from "./work/recent-faces.js";

/**
 * @typedef {import("./opening.js").Incoming} Incoming
 * @typedef {import("./work/recent-faces.js").ShownFace} ShownFace
 *
 * @typedef {object} Context
 * @property {Promise<import("./viewport/host.js").Host | undefined>} host undefined if the browser cannot draw in 3D
 * @property {import("./photo/vision-client.js").VisionClient} vision
 * @property {import("./photo/photo-overlay.js").PhotoOverlay} overlay
 * @property {import("./photo/face-choice.js").FaceChoice} faceChoice
 * @property {import("./work/autosave.js").Autosave} autosave
 * @property {(extraction_ms: number | undefined) => void} onOpened
 */

/**
 * Opens faces on the page, with its panels, notices and autosave.
 *
 * @param {Context} context
 */
export function pageOpening({ host, vision, overlay, faceChoice, autosave, onOpened }) {
  const opening = new Opening(host, vision, {
    begun: () => {
      dismissNotices();
      hideProgress();
    },
    progress: (stage, fraction) => (stage === "loading" ? showLoading() : showStage(stage, fraction)),
    prepare: async ({ face, faces }, picture) => {
      const prepared = await overlay.prepare(face, picture);
      faceChoice.prepare(faces, picture);
      return prepared;
    },
    leaving: () => autosave.flush(),
    started: (face) => autosave.start(face),
    opened: (incoming) => {
      showOpened(incoming);
      showFaces(incoming);
      // Fields that were being typed in can be updated again.
      host.then((ready) => ready?.announce());
      onOpened(incoming.extraction_ms);
    },
    photosChanged: (shown) => {
      autosave.flush();
      showFaces(shown);
    },
    notAdded: showNotAdded,
    addedLittle: (name) => showRemark("adds-little", { name }),
    // The host reports traps.
    failed: (error) => isTrap(error) || showError(error),
    ended: (isNewest) => {
      if (isNewest) hideProgress();
      faceChoice.mark(opening.face);
    },
  });

  /** @param {ShownFace} shown */
  function showFaces({ faces }) {
    faceChoice.show(faces, recentFaces(opening.earlier, faces)).catch((error) => console.warn("cannot show the recent faces:", error));
  }
  return opening;
}

/** @param {Incoming} incoming */
function showOpened({ changedElsewhere, isDoubtful, ofThisVisit = false }) {
  const isIn3d = document.body.dataset["host"] === "open";
  document.body.dataset["state"] = isIn3d ? "face" : "photo";
  byId("welcome", HTMLElement).hidden = true;
  byId("toolbar", HTMLDivElement).hidden = !isIn3d;
  // Collapse the photo to make room for the tools; without a 3D view, keep it open.
  byId("section-photo", HTMLDetailsElement).open = !isIn3d;
  resetPanel(ofThisVisit);
  if (changedElsewhere) showError({ code: "changed-elsewhere", message: "", hint: "" });
  else if (isDoubtful) showRemark("may-not-be-a-face", {});
  else if (isIn3d) showHints();
}
