// What a GLB says beside its mesh, by the container's specification alone.

/** The JSON of a GLB. @param {Buffer} bytes */
export function jsonOf(bytes) {
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
}

/** Numbers kept as base64 of little-endian 32-bit floats, in rows. @param {string} text @param {number} width of a row */
export function rowsOf(text, width) {
  const bytes = Buffer.from(text, "base64");
  const numbers = Array.from({ length: bytes.length / 4 }, (_, at) => bytes.readFloatLE(4 * at));
  return Array.from({ length: numbers.length / width }, (_, row) => numbers.slice(width * row, width * (row + 1)));
}
