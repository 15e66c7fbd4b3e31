import type { Face } from "./face.ts";

export interface ShownFace {
  face: Face;
  /** all faces of the photo, including `face` */
  faces: Face[];
}

/** Number of earlier photos that are offered. */
const MAX_PHOTOS = 3;

/**
 * The faces shown before `now`, latest first, without duplicates, limited to the latest photos.
 *
 * @param shown latest first
 */
export function shownBefore(shown: (ShownFace | undefined)[], now: Face): ShownFace[] {
  const others = shown.filter((entry) => entry !== undefined).filter(({ face }) => face !== now);
  const unique = others.filter(({ face }, index) => others.findIndex((other) => other.face === face) === index);
  const photos = [...new Set(unique.map(({ face }) => firstFileKey(face)))].filter((photo) => photo !== firstFileKey(now));
  const kept = new Set([firstFileKey(now), ...photos.slice(0, MAX_PHOTOS)]);
  return unique.filter(({ face }) => kept.has(firstFileKey(face)));
}

/**
 * The faces offered in the recent list: the one shown last, and the latest of each other photo.
 *
 * @param before latest first
 * @param faces of the current photo
 */
export function recentFaces(before: ShownFace[], faces: Face[]): Face[] {
  const photos = new Set(faces.map(firstFileKey));
  return before
    .filter(({ face }, index) => {
      const isNew = !photos.has(firstFileKey(face));
      photos.add(firstFileKey(face));
      return index === 0 || isNew;
    })
    .map(({ face }) => face);
}

/** Key of a face's first file. */
function firstFileKey({ files }: Face) {
  return files[0]?.key;
}
