import { pageOpening } from "./page-opening.js";
import { setUpLivePreview } from "./live/live-preview.js";
import { announce } from "./page/announce.js";
import { setUpDialogs } from "./page/dialogs.js";
import { byId, onAction } from "../src/dom.ts";
import { completeHint, setUpHints } from "./page/hint.js";
import { hideNotice, setUpNotice, showError } from "./page/notice.js";
import { setUpExport } from "../src/export.ts";
import { setUpPanels } from "../src/page-panels.ts";
import { textOf } from "../src/phrase.ts";
import { storeOffline } from "../src/offline.ts";
import { useVersion } from "../src/version.ts";
import { countRequests } from "./page/privacy.js";
import { setUpProgress } from "./page/progress.js";
import { remember, remembered } from "./page/remember.js";
import { setUpTabs } from "./page/tabs.js";
import { afterNextFrame } from "./page/tasks.js";
import { setUpTheme } from "./page/theme.js";
import { Validator } from "./page/validator.js";
import { PaperPanel } from "./panel/paper-panel.js";
import { PhotosPanel } from "./panel/photos-panel.js";
import { setUpCamera } from "./photo/camera.js";
import { FaceChoice } from "./photo/face-choice.js";
import { setUpPhotoInput } from "./photo/photo-input.js";
import { PhotoOverlay } from "./photo/photo-overlay.js";
import { loadSample, showSample } from "./photo/sample.js";
import { VisionClient } from "./photo/vision-client.js";
import { setUpBeforeAfter } from "./viewport/before-after.js";
import { setUpSplitView } from "./viewport/split-view.js";
import { setUpBrushMarks } from "./viewport/brush-marks.js";
import { setUpViewportInsets } from "./viewport/viewport-insets.js";
import { LandmarkMarks } from "./viewport/landmark-marks.js";
import { setUpPulse } from "./viewport/pulse.js";
import { setUpScene } from "./viewport/scene-switch.js";
import { setUpEditKeys, setUpViewKeys } from "./viewport/shortcuts.js";
import { WholeTexture } from "./viewport/whole-texture.js";
import { Host } from "./viewport/host.js";
import { onLocaleChange, language, languages, loadWords, setLanguage, translatePage } from "./words/words.js";
import { Autosave } from "./work/autosave.js";
import { FaceFiles } from "./work/face-files.js";

useVersion();
await loadWords(remembered("language") ?? navigator.language);
setUpLanguage();
setUpNotice();
setUpProgress();
setUpHints();
setUpTabs();
setUpDialogs();

const vision = new VisionClient();
const overlay = new PhotoOverlay();
const autosave = new Autosave(() => opening.remember());
const validator = new Validator();
/** @type {PaperPanel | undefined} */
let paper;
const host = openHost();
const faceChoice = new FaceChoice((face) => opening.openFace(face));
const opening = pageOpening({ host, vision, overlay, faceChoice, autosave, onOpened: (extraction_ms) => paper?.forget(extraction_ms) });

setUpTheme((theme) => host.then((opened) => opened?.apply({ theme })));
setUpPhotoInput((file) => opening.openFile(file));
setUpCamera((photo) => opening.openFile(photo, "selfie"));
setUpLivePreview({ host, vision, opening });
onAction("sample", () => opening.openFile(loadSample(), "sample"));
autosave.offer((read) => opening.openWork(read));
countRequests(loadInBackground());
dispatchEvent(new Event("started"));

/** Sets up the 3D view and the panels that use it. Resolves to undefined if the browser cannot draw in 3D. */
async function openHost() {
  try {
    const opened = await Host.open(byId("viewport", HTMLCanvasElement), { show: showError, hide: hideNotice });
    overlay.follow(opened);
    opened.onSaid((said) => announce(textOf(said)));
    setUpPanels(opened);
    setUpEditKeys({ undo: () => opened.apply("undo"), redo: () => opened.apply("redo"), cancel: () => opened.apply("cancel") });
    followMotionSetting(opened);
    new LandmarkMarks(opened, { tag: byId("landmark-tag", HTMLOutputElement), overlay, onGesture: completeHint, announce });
    setUpBeforeAfter(opened);
    setUpPulse(opened);
    setUpViewportInsets(opened);
    setUpViewKeys(opened, completeHint);
    setUpScene(opened);
    setUpSplitView(opened);
    setUpBrushMarks(opened);
    new PhotosPanel(opened, opening, vision);
    const files = new FaceFiles(opened, vision, opening);
    new WholeTexture(opened, files, (isMaking) => document.body.toggleAttribute("data-texture", isMaking));
    setUpExport({ host: opened, opening, validator, files, pictureSize: () => overlay.pictureSize });
    paper = new PaperPanel(opened);
    autosave.follow(opened);
    opened.onRestart(() => resetView(opened));
    opened.apply("close");
    document.body.dataset["host"] = "open";
    return opened;
  } catch (error) {
    document.body.dataset["host"] = "closed";
    showError(error);
    return undefined;
  }
}

/** Loads what the first view does not need: workers, sample photo and offline copy. */
async function loadInBackground() {
  await afterNextFrame();
  vision.start();
  await vision.ready;
  await host;
  await Promise.allSettled([showSample(), validator.start(), storeOffline()]);
}

/**
 * Sets up a restarted studio, which then gets its face again.
 *
 * @param {Host} opened
 */
async function resetView(opened) {
  const theme = document.documentElement.dataset["theme"] === "dark" ? "dark" : "light";
  opened.apply({ theme });
  opened.apply({ "reduced-motion": matchMedia("(prefers-reduced-motion: reduce)").matches });
  opened.apply("close");
  paper?.forget(undefined);
}

/** @param {Host} opened */
function followMotionSetting(opened) {
  const setting = matchMedia("(prefers-reduced-motion: reduce)");
  const apply = () => opened.apply({ "reduced-motion": setting.matches });
  setting.addEventListener("change", apply);
  apply();
}

function setUpLanguage() {
  const choice = byId("language", HTMLSelectElement);
  choice.replaceChildren(...languages().map(({ id, name }) => new Option(name, id)));
  choice.value = language();
  choice.addEventListener("change", () => {
    setLanguage(choice.value).then(() => remember("language", language()), () => (choice.value = language()));
  });
  onLocaleChange(translatePage);
}
