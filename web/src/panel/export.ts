import { onAction } from "../page/dom.ts";
import { download } from "../page/download.ts";
import { showError } from "../page/notice.ts";
import { toast } from "../page/toast.ts";
import { validate } from "../page/validator.ts";
import type { Opening } from "../opening.ts";
import { setUpArLink } from "../share/ar-link.ts";
import { beforeAndAfter } from "../share/before-and-after.ts";
import { ClipPanel } from "../share/clip-panel.ts";
import { canSend, send } from "../share/send.ts";
import { sideBySide } from "../share/side-by-side.ts";
import { canCopyPictures, copyPicture, viewPicture } from "../share/view-picture.ts";
import type { Host } from "../viewport/host.ts";
import { t } from "../words/words.ts";
import { leadPhotoOf } from "../work/face.ts";
import type { FaceFiles } from "../work/face-files.ts";
import { fileName } from "../work/file-name.ts";
import type { Report } from "../../wasm/rosto-studio-web.js";
import { setUpPrint } from "./print.ts";

const PNG = "image/png";

interface Context {
  host: Host;
  opening: Opening;
  files: FaceFiles;
  /** Size in px of the lead photo's picture. */
  pictureSize: () => { width: number; height: number };
}

/** Performs the actions of the export panel: files, pictures and sharing. */
export function setUpExport(context: Context) {
  const { host, opening, files } = context;
  const fail = (error: unknown) => host.fail(error);
  const makeMesh = async (format: string) => {
    // The face and its density may change meanwhile.
    const [options, name] = host.answer((studio) => [studio.fileOptions(), studio.fileName("")]);
    const { bytes, extension, mediaType } = await files.mesh(format, options);
    return new File([bytes], name + extension, { type: mediaType });
  };
  const print = setUpPrint(host, files);
  offerGlb(context, makeMesh);
  const { formats, printedFormats } = host.catalogue;
  for (const id of formats) {
    const refuse = printedFormats.includes(id) ? print.refuse : fail;
    if (id !== "glb") onAction(`download-${id}`, () => makeMesh(id).then(save).catch(refuse));
  }
  onAction("save-project", async () => {
    const name = fileName(opening.face, "rosto");
    await files.project().then((bytes) => save(new File([bytes], name, { type: "application/octet-stream" })), fail);
  });
  setUpArLink(() => makeMesh("usdz"), fail);
  offerPhoto(context);
  offerPictures(context);
  new ClipPanel(host, opening);
}

/** Validating, downloading and sharing the GLB. */
function offerGlb({ host }: Context, makeMesh: (format: string) => Promise<File>) {
  const report = (about: Report) => host.applyShown({ report: about });
  const make = async (isValidated: boolean) => {
    report({ "glb-started": { isValidated } });
    try {
      const file = await makeMesh("glb");
      const validated = isValidated ? await validate(new Uint8Array(await file.arrayBuffer())) : undefined;
      const verdict = validated ? { validated } : "unchecked";
      report({ "glb-made": { bytes: file.size, verdict: isValidated ? verdict : undefined } });
      return file;
    } catch (error) {
      report("glb-failed");
      host.fail(error);
      return undefined;
    }
  };
  onAction("check-glb", () => make(true));
  onAction("download-glb", () => make(true).then((file) => file && save(file)));
  onAction("share-glb", () => make(false).then((file) => file && share(file)).catch((error) => host.fail(error)));
}

/** The edited photo, at full size if its own file was opened. */
function offerPhoto({ host, opening, files, pictureSize }: Context) {
  const report = (about: Report) => host.applyShown({ report: about });
  let isWriting = false;
  const write = async (type: "png" | "jpeg", extension: string) => {
    const { face } = opening;
    if (!face || isWriting) return;
    isWriting = true;
    report({ "writing-photo": true });
    try {
      const name = fileName(face, extension, "edited");
      download(await files.editedPhoto(`image/${type}`), name, `image/${type}`);
      toast(t("export.saved", { name }));
    } catch (error) {
      showError(error);
    } finally {
      isWriting = false;
      report({ "writing-photo": false });
    }
  };
  onAction("download-photo-png", () => write("png", "png"));
  onAction("download-photo-jpeg", () => write("jpeg", "jpg"));
  host.onChange(() => {
    const { face } = opening;
    if (!face) return;
    const { width, height } = pictureSize();
    report({ face: { stem: face.name, savedPx: leadPhotoOf(face).source.kind === "saved" ? [width, height] : undefined } });
  });
}

/** Pictures of the view. */
function offerPictures({ host, opening }: Context) {
  const fail = (error: unknown) => host.fail(error);
  const isTransparent = () => host.ask((studio) => studio.isTransparent) ?? false;
  host.applyShown({ report: { abilities: { sharesModels: canSend("model/gltf-binary", "face.glb"), sharesPictures: canSend(PNG), copiesPictures: canCopyPictures() } } });
  const view = async () => {
    const name = fileName(opening.face, "png");
    return new File([await viewPicture(host, isTransparent())], name, { type: PNG });
  };
  const pair = async () => {
    const name = fileName(opening.face, "png", "before-after");
    const { before, after } = await beforeAndAfter(host, isTransparent());
    return new File([await sideBySide(before, after, { before: t("before"), after: t("after") })], name, { type: PNG });
  };
  onAction("download-picture", () => view().then(save, fail));
  onAction("copy-picture", () => copyPicture(view()).then(() => toast(t("export.copied")), fail));
  onAction("download-pair", () => pair().then(save, fail));
  onAction("share-pair", () => pair().then(share).catch(fail));
}

async function share(file: File) {
  if (!(await send(file))) save(file);
}

function save(file: File) {
  download(file, file.name, file.type);
  toast(t("export.done", { file: file.name }));
}
