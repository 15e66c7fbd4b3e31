import { stemOf, stemOfMesh } from "./file-name.ts";
import type { Opened } from "../worker/protocol.ts";
import type { PhotoRemark } from "../../wasm/rosto-vision-web.js";

export interface SourceFile {
  /** the worker names the file's pictures `KEY/0`, `KEY/1`, … */
  key: string;
  file: Blob;
  /** a photo, or a GLB or project */
  kind: "photo" | "saved";
}

export interface Face {
  /** stem of exported file names */
  name: string;
  files: SourceFile[];
  /** the photos of the face in the studio's format, in the order they were added */
  photos: string;
  /** the picture of each photo */
  pictures: string[];
  /** index of the lead photo */
  lead: number;
  /** on a newly found face in its photo, the most important first */
  remarks?: PhotoRemark[] | undefined;
  /** in the studio's format; absent for a newly found face */
  edits?: string | undefined;
  /** settings and view in the studio's format; absent before the face was on the screen */
  preferences?: string;
}

export interface PhotoView {
  /** of the upright photo in which the landmarks were found */
  width_px: number;
  height_px: number;
  /** 468 or 478 × (x/W, y/H, z/W), irises last */
  landmarks: Float32Array;
}

export type FacePhoto = Pick<Face, "photos" | "pictures" | "files">;

/** Offsets in the bytes of a photo: see docs/formats.md. */
const [WIDTH_AT, HEIGHT_AT, COUNT_AT, LANDMARKS_AT] = [1, 5, 9, 11];
const VERSION = 1;

/**
 * The faces in a file, most prominent first.
 *
 * @param name stem of exported file names
 */
export function facesOf({ key, file, opened: { kind, faces } }: Opened, name: string): Face[] {
  const files = [{ key, file, kind }];
  return faces.map(({ photos, edits, pictures, lead, remarks }, index) => {
    return { name: index === 0 ? name : `${name}-${index + 1}`, files, photos, pictures, lead, edits, remarks };
  });
}

/** Name of the face in a file, without the vertex count that the page appends to the names of other densities. */
export function nameIn(file: Blob, edits: string | undefined, defaultDensity: number | undefined) {
  const isMesh = file instanceof File && /\.glb$/i.test(file.name);
  const isOther = edits !== undefined && ![undefined, JSON.parse(edits).density].includes(defaultDensity);
  return isMesh && isOther ? stemOfMesh(file) : stemOf(file);
}

/** Removes the edits that apply only to the photo. */
export function withoutPhotoEdit(edits: string) {
  const { photo_edit: _, ...others } = JSON.parse(edits);
  return JSON.stringify(others);
}

/** Reads the photos of a face. Throws if they are not in the studio's format. */
export function viewsOf(photos: string): PhotoView[] {
  return (JSON.parse(photos) as { observation: string }[]).map(({ observation }) => {
    const bytes = Uint8Array.from(atob(observation), (character) => character.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    if (view.getUint8(0) !== VERSION) throw new Error("a photo of another version");
    const length = 3 * view.getUint16(COUNT_AT, true);
    const landmarks = Float32Array.from({ length }, (_, at) => view.getFloat32(LANDMARKS_AT + 4 * at, true));
    return { width_px: view.getUint32(WIDTH_AT, true), height_px: view.getUint32(HEIGHT_AT, true), landmarks };
  });
}

/** Landmarks and size of the lead photo. */
export function leadOf({ photos, lead }: Face) {
  const view = viewsOf(photos)[lead];
  if (!view) throw new Error("no lead photo");
  return view;
}

/** Picture of the lead photo, and the file that contains it. */
export function leadPhotoOf({ pictures, lead, files }: Pick<Face, "pictures" | "lead" | "files">) {
  const picture = pictures[lead] ?? "";
  const [source] = filesWith(files, [picture]);
  if (!source) throw new Error("no file of the lead photo");
  return { picture, source };
}

/** One photo of a face. */
export function photoOf({ photos, pictures, files }: Face, picture: string): FacePhoto {
  const photo = JSON.parse(photos)[pictures.indexOf(picture)];
  return { photos: JSON.stringify([photo]), pictures: [picture], files: filesWith(files, [picture]) };
}

/** The files that contain one of the pictures. */
export function filesWith(files: SourceFile[], pictures: string[]) {
  const keys = pictures.map((picture) => picture.slice(0, picture.lastIndexOf("/")));
  return files.filter(({ key }) => keys.includes(key));
}
