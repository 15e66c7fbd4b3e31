// Modifies saved files, as other programs, other versions or attackers might.

const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/** Replaces a project's header by the value that `change` returns, or by its modified argument. */
export function changedProject(file, change) {
  const end = file.indexOf("\n");
  const header = JSON.parse(file.subarray(0, end).toString());
  return Buffer.concat([Buffer.from(JSON.stringify(change(header) ?? header)), file.subarray(end)]);
}

/** Byte offsets in the observation of a photo. */
const [WIDTH_AT, LANDMARKS_AT] = [1, 11];

/** Sets the width of the first photo to 0 px. @param {{ photos: { observation: string }[] }} fields of a project or GLB */
export function removeWidth(fields) {
  changeObservation(fields, (bytes) => bytes.writeUInt32LE(0, WIDTH_AT));
}

/** A project whose landmarks all have the same position. @param {Buffer} file */
export function projectWithoutShape(file) {
  return changedProject(file, (header) => changeObservation(header, (bytes) => bytes.fill(0, LANDMARKS_AT, LANDMARKS_AT + 468 * 3 * 4)));
}

/** Scatters the landmarks of the first photo over it. @param {{ photos: { observation: string }[] }} fields of a file */
export function scatterLandmarks(fields) {
  changeObservation(fields, (bytes) => {
    for (let number = 0; number < 468 * 3; number++) {
      bytes.writeFloatLE(((number + 1) * 0.618034) % 1, LANDMARKS_AT + 4 * number);
    }
  });
}

/** Replaces the history with `count` entries. @param {{ history: { entries: object[] } }} fields @param {number} count */
export function lengthenHistory({ history }, count) {
  history.entries = new Array(count).fill({ label: "symmetry", switch: "off", symmetrise: { share: 0.5 } });
}

/** @param {{ photos: { observation: string }[] }} fields @param {(bytes: Buffer) => void} change */
function changeObservation({ photos: [photo] }, change) {
  const bytes = Buffer.from(photo.observation, "base64");
  change(bytes);
  photo.observation = bytes.toString("base64");
}

/** JSON and binary chunk of a GLB. @param {Buffer} file */
export function partsOfGlb(file) {
  const length = file.readUInt32LE(HEADER_BYTES);
  const end = HEADER_BYTES + CHUNK_HEADER_BYTES + length;
  const json = JSON.parse(file.subarray(HEADER_BYTES + CHUNK_HEADER_BYTES, end).toString());
  return { json, bytes: Buffer.from(file.subarray(end + CHUNK_HEADER_BYTES)) };
}

/** @param {{ json: any, bytes: Buffer }} parts */
export function glbOf({ json, bytes }) {
  const chunks = Buffer.concat([chunk("JSON", Buffer.from(JSON.stringify(json)), 0x20), chunk("BIN\0", bytes, 0)]);
  const header = Buffer.alloc(HEADER_BYTES);
  header.write("glTF");
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(HEADER_BYTES + chunks.length, 8);
  return Buffer.concat([header, chunks]);
}

/** Replaces the bytes of one buffer view, also by a different length. */
export function withView(parts, view, replacement) {
  let joined = Buffer.alloc(0);
  const bufferViews = parts.json.bufferViews.map((told, place) => {
    const bytes = place === view ? replacement : viewOf(parts, place);
    const moved = { ...told, byteOffset: joined.length, byteLength: bytes.length };
    joined = Buffer.concat([joined, padded(bytes, 0)]);
    return moved;
  });
  return glbOf({ json: { ...parts.json, bufferViews, buffers: [{ byteLength: joined.length }] }, bytes: joined });
}

/** Bytes of one buffer view. */
export function viewOf({ json, bytes }, view) {
  const { byteOffset = 0, byteLength } = json.bufferViews[view];
  return bytes.subarray(byteOffset, byteOffset + byteLength);
}

/** A GLB chunk, padded to a multiple of four bytes. */
function chunk(kind, bytes, by) {
  const body = padded(bytes, by);
  const header = Buffer.from(`\0\0\0\0${kind}`);
  header.writeUInt32LE(body.length);
  return Buffer.concat([header, body]);
}

/** @param {Buffer} bytes @param {number} by */
function padded(bytes, by) {
  return Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, by)]);
}
