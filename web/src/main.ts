import { pageOpening } from "./page-opening.ts";
import { setUpLivePreview } from "./live/live-preview.ts";
import { announce } from "./page/announce.ts";
import { setUpDialogs } from "./page/dialogs.ts";
import { byId, onAction } from "./page/dom.ts";
import { completeHints, setUpHints } from "./page/hint.ts";
import { hideNotice, setUpNotice, showError } from "./page/notice.ts";
import { countRequests } from "./page/privacy.ts";
import { setUpProgress } from "./page/progress.ts";
import { setUpLanguage, setUpTheme, theme } from "./page/settings.ts";
import { setUpTabs } from "./page/tabs.ts";
import { afterNextFrame, nextTask } from "./page/tasks.ts";
import { startValidator } from "./page/validator.ts";
import { loadPictures, setUpExport } from "./panel/export.ts";
import { setUpPanels } from "./panel/page-panels.ts";
import { setUpPaper } from "./panel/paper-panel.ts";
import { setUpPhotos } from "./panel/photos-panel.ts";
import { setUpSheet } from "./panel/sheet.ts";
import { textOf } from "./panel/phrase.ts";
import { setUpCamera } from "./photo/camera.ts";
import { FaceChoice } from "./photo/face-choice.ts";
import { setUpPhotoInput } from "./photo/photo-input.ts";
import { PhotoOverlay } from "./photo/photo-overlay.ts";
import { loadSample, showSample } from "./photo/sample.ts";
import { SeveralPhotos } from "./photo/several-photos.ts";
import { VisionClient } from "./photo/vision-client.ts";
import { storeOffline, useVersion } from "./offline.ts";
import { setUpGestures } from "./viewport/gestures.ts";
import { Host } from "./viewport/host.ts";
import { setUpMarks } from "./viewport/landmark-marks.ts";
import { setUpBrushMarks, setUpViewportInsets } from "./viewport/overlays.ts";
import { setUpKeys } from "./viewport/shortcuts.ts";
import { setUpBeforeAfter, setUpViews } from "./viewport/views.ts";
import { followTexture } from "./viewport/whole-texture.ts";
import { Autosave } from "./work/autosave.ts";
import { faceFiles } from "./work/face-files.ts";

const REDUCED_MOTION = matchMedia("(prefers-reduced-motion: reduce)");

useVersion();
setUpDialogs();
await setUpLanguage();
setUpNotice();
if (!isSecureContext) showError({ code: "needs-https", message: location.href, hint: "" });
setUpProgress();
setUpHints();
setUpTabs();
setUpSheet();

const vision = new VisionClient();
const overlay = new PhotoOverlay();
const autosave = new Autosave(() => opening.remember());
let forgetPaper: ((extraction_ms: number | undefined) => void) | undefined;
const host = openHost();
const faceChoice = new FaceChoice((face) => opening.openFace(face));
const onOpened = (extraction_ms: number | undefined) => forgetPaper?.(extraction_ms);
const opening = pageOpening({ host, vision, overlay, faceChoice, autosave, onOpened });

setUpTheme(applyPreferences);
REDUCED_MOTION.addEventListener("change", applyPreferences);
const severalPhotos = new SeveralPhotos(opening);
setUpPhotoInput({
  open: (file) => {
    severalPhotos.close();
    opening.openFile(file);
  },
  ask: (photos) => severalPhotos.ask(photos),
});
setUpCamera((photo) => opening.openFile(photo, "selfie"));
setUpLivePreview({ host, vision, opening });
onAction("sample", () => opening.openFile(loadSample(), "sample"));
autosave.offer((read) => opening.openWork(read));
countRequests(loadInBackground());
byId("panel", HTMLElement).inert = false;
dispatchEvent(new Event("started"));

/** Sets up the 3D view and the panels that use it. Resolves to undefined if the browser cannot draw in 3D. */
async function openHost() {
  try {
    const opened = await Host.open(byId("viewport", HTMLCanvasElement), { show: showError, hide: hideNotice, offerRetry });
    overlay.follow(opened);
    opened.on("applied", ({ said }) => said && announce(textOf(said)));
    // Several tasks, to keep the page responsive.
    await nextTask();
    setUpPanels(opened);
    await nextTask();
    setUpMarks(opened, { tag: byId("landmark-tag", HTMLOutputElement), overlay, announce });
    setUpGestures(opened, () => completeHints("turn"));
    setUpKeys(opened, window, (id) => id.startsWith("key.turn") && completeHints("turn"));
    opened.on("change", ({ entryCount, tick }) => (entryCount > 0 || tick.isEditing) && completeHints("turn", "drag"));
    for (const setUp of [setUpBeforeAfter, setUpViewportInsets, setUpViews, setUpBrushMarks]) setUp(opened);
    setUpPhotos(opened, opening, vision);
    const files = faceFiles(opened, vision, opening);
    followTexture(opened, files, (isMaking) => document.body.toggleAttribute("data-texture", isMaking));
    setUpExport({ host: opened, opening, files, pictureSize: () => overlay.pictureSize });
    forgetPaper = setUpPaper(opened, files);
    autosave.follow(opened);
    // A restarted studio then gets its face again.
    opened.onRestart(async () => {
      await applyPreferences();
      opened.apply("close");
      forgetPaper?.(undefined);
    });
    opened.apply("close");
    document.body.dataset["host"] = "open";
    return opened;
  } catch (error) {
    document.body.dataset["host"] = "closed";
    showError(error);
    return undefined;
  }
}

function offerRetry(error: unknown, retry: () => void) {
  // The page has finished loading what it can.
  document.body.dataset["host"] = "waiting";
  showError(error, "studio", retry);
}

async function applyPreferences() {
  const opened = await host;
  opened?.apply({ theme: theme() });
  opened?.apply({ "reduced-motion": REDUCED_MOTION.matches });
}

/** Loads what the first view does not need: workers, sample photo and offline copy. */
async function loadInBackground() {
  await afterNextFrame();
  vision.start();
  await vision.ready;
  await host;
  await Promise.allSettled([showSample(), startValidator(), loadPictures(), storeOffline()]);
}
