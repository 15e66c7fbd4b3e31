import { viewsOf } from "./face.ts";
import type { Face, SourceFile } from "./face.ts";

/** Type guards for database rows. */
export interface FaceRow {
  name: string;
  files: (Omit<SourceFile, "file"> & { file: Blob | ArrayBuffer; })[];
}

export type Work = Required<Pick<Face, "photos" | "pictures" | "lead" | "edits" | "preferences">>;

export type StoredWork = Work & { order: number; };

export function isFaceRow(row: any): row is FaceRow {
  const { name, files } = row ?? {};
  return typeof name === "string" && Array.isArray(files) && files.every(isFile);
}

export function isWorkRow(row: any): row is StoredWork {
  const { photos, pictures, lead, edits, preferences, order } = row ?? {};
  const hasTexts = isJson(edits) && typeof preferences === "string" && isCount(lead) && isCount(order);
  return hasTexts && Array.isArray(pictures) && lead < pictures.length && photoCount(photos) === pictures.length;
}

function isFile({ key, file, kind }: any) {
  return typeof key === "string" && (file instanceof Blob || file instanceof ArrayBuffer) && ["photo", "saved"].includes(kind);
}

/** Number of photos; undefined if the text is damaged. */
function photoCount(photos: any) {
  try {
    return viewsOf(photos).length;
  } catch {
    return undefined;
  }
}

function isCount(value: any) {
  return Number.isSafeInteger(value) && value >= 0;
}

function isJson(text: any) {
  try {
    return typeof text === "string" && Boolean(JSON.parse(text));
  } catch {
    return false;
  }
}
