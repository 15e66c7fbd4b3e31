// Files that were saved on the page, as other programs, other versions or ill will may have changed them.

const JSON_CHUNK = 0x4e4f534a;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/**
 * A project with another header.
 *
 * @param {Buffer} file
 * @param {(header: any) => any} change is given the header, which it may change; what it returns stands for it
 */
export function changedProject(file, change) {
  const end = file.indexOf("\n");
  const header = JSON.parse(file.subarray(0, end).toString());
  return Buffer.concat([Buffer.from(JSON.stringify(change(header) ?? header)), file.subarray(end)]);
}

/** A project whose landmarks are all at one place. @param {Buffer} file */
export function projectWithoutShape(file) {
  const changed = Buffer.from(file);
  const start = file.indexOf("\n") + 1;
  return changed.fill(0, start, start + 468 * 3 * 4);
}

/** The JSON of a GLB, and its bytes. @param {Buffer} file */
export function partsOfGlb(file) {
  const length = file.readUInt32LE(HEADER_BYTES);
  const end = HEADER_BYTES + CHUNK_HEADER_BYTES + length;
  const json = JSON.parse(file.subarray(HEADER_BYTES + CHUNK_HEADER_BYTES, end).toString());
  return { json, bytes: Buffer.from(file.subarray(end + CHUNK_HEADER_BYTES)) };
}

/** @param {{ json: any, bytes: Buffer }} parts */
export function glbOf({ json, bytes }) {
  const text = padded(Buffer.from(JSON.stringify(json)), 0x20);
  const data = padded(bytes, 0);
  const header = Buffer.alloc(HEADER_BYTES);
  header.write("glTF");
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(HEADER_BYTES + 2 * CHUNK_HEADER_BYTES + text.length + data.length, 8);
  return Buffer.concat([header, chunkHeader(text, JSON_CHUNK), text, chunkHeader(data, 0x004e4942), data]);
}

/**
 * A GLB in which one of the bytes' parts is another, of whatever length.
 *
 * @param {{ json: any, bytes: Buffer }} parts
 * @param {number} view
 * @param {Buffer} replacement
 */
export function withView({ json, bytes }, view, replacement) {
  const views = json.bufferViews.map(({ byteOffset = 0, byteLength }, place) =>
    place === view ? replacement : bytes.subarray(byteOffset, byteOffset + byteLength),
  );
  let offset = 0;
  const bufferViews = json.bufferViews.map((told, place) => {
    const moved = { ...told, byteOffset: offset, byteLength: views[place].length };
    offset += padded(views[place], 0).length;
    return moved;
  });
  const joined = Buffer.concat(views.map((part) => padded(part, 0)));
  return glbOf({ json: { ...json, bufferViews, buffers: [{ byteLength: joined.length }] }, bytes: joined });
}

/** The bytes of one part of a GLB. */
export function viewOf({ json, bytes }, view) {
  const { byteOffset = 0, byteLength } = json.bufferViews[view];
  return bytes.subarray(byteOffset, byteOffset + byteLength);
}

/** @param {Buffer} chunk @param {number} kind */
function chunkHeader(chunk, kind) {
  const header = Buffer.alloc(CHUNK_HEADER_BYTES);
  header.writeUInt32LE(chunk.length, 0);
  header.writeUInt32LE(kind, 4);
  return header;
}

/** @param {Buffer} bytes @param {number} by */
function padded(bytes, by) {
  return Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, by)]);
}
