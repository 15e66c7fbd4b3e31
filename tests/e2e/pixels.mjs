/** @typedef {{ width: number, height: number, data: Uint8Array }} Pixels RGBA */
/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box as fractions of the picture's size */

/** Mean colour of a box, each channel 0 to 255. @param {Pixels} pixels @param {Box} box */
export function meanColour(pixels, box) {
  const sum = [0, 0, 0];
  let count = 0;
  for (let y = Math.floor(box.top * pixels.height); y < box.bottom * pixels.height; y++) {
    for (let x = Math.floor(box.left * pixels.width); x < box.right * pixels.width; x++) {
      const at = 4 * (y * pixels.width + x);
      for (let channel = 0; channel < 3; channel++) sum[channel] += pixels.data[at + channel];
      count += 1;
    }
  }
  return sum.map((total) => total / count);
}

/**
 * Maximum difference between the mean colours of a box in two pictures, 0 to 255.
 *
 * @param {Pixels} a
 * @param {Pixels} b
 * @param {Box} box
 */
export function meanStep(a, b, box) {
  const other = meanColour(b, box);
  return Math.max(...meanColour(a, box).map((level, channel) => Math.abs(level - other[channel])));
}

/** Chromaticity: shares of red, green and blue that sum to 1. @param {number[]} colour */
export function chromaticity(colour) {
  const sum = colour.reduce((a, b) => a + b);
  return colour.map((channel) => channel / sum);
}

/** Share of pixels in which two pictures of the same size differ noticeably. @param {Pixels} a @param {Pixels} b */
export function difference(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error("the pictures differ in size");
  let changed = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const step = Math.max(...[0, 1, 2].map((channel) => Math.abs(a.data[at + channel] - b.data[at + channel])));
    if (step > 4) changed += 1;
  }
  return changed / (a.width * a.height);
}

/** Maximum difference between any channel of two pictures of the same size. @param {Pixels} a @param {Pixels} b */
export function largestStep(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error("the pictures differ in size");
  return a.data.reduce((most, value, at) => Math.max(most, Math.abs(value - b.data[at])), 0);
}

/**
 * Bounding box, in px, of the differences between two pictures of the same size.
 *
 * @param {Pixels} a
 * @param {Pixels} b
 */
export function differingBox(a, b) {
  const box = { left: a.width, top: a.height, right: 0, bottom: 0 };
  for (let at = 0; at < a.data.length; at += 4) {
    if ([0, 1, 2].every((channel) => a.data[at + channel] === b.data[at + channel])) continue;
    const [x, y] = [(at / 4) % a.width, Math.floor(at / 4 / a.width)];
    box.left = Math.min(box.left, x);
    box.top = Math.min(box.top, y);
    box.right = Math.max(box.right, x);
    box.bottom = Math.max(box.bottom, y);
  }
  return box;
}

/** Number of different colours, of 4096; 1 or 2 for a blank picture. @param {Pixels} pixels */
export function colourCount(pixels) {
  const seen = new Set();
  for (let at = 0; at < pixels.data.length; at += 4) {
    seen.add(((pixels.data[at] >> 4) << 8) | ((pixels.data[at + 1] >> 4) << 4) | (pixels.data[at + 2] >> 4));
  }
  return seen.size;
}

/**
 * Difference within `reach_px` of a position in px.
 *
 * @param {Pixels} a
 * @param {Pixels} b
 * @param {{ x: number, y: number }} place
 */
export function differenceNear(a, b, place, reach_px) {
  return difference(around(a, place, reach_px), around(b, place, reach_px));
}

/**
 * Centre, in px, of the pixels whose channels are within `most` of a colour; NaN if there are none.
 *
 * @param {Pixels} pixels
 */
export function middleOf({ width, data }, colour, most) {
  const sum = { x: 0, y: 0, count: 0 };
  for (let at = 0; at < data.length; at += 4) {
    if (colour.some((value, channel) => Math.abs(data[at + channel] - value) > most)) continue;
    sum.x += ((at / 4) % width) + 0.5;
    sum.y += Math.floor(at / 4 / width) + 0.5;
    sum.count += 1;
  }
  return { x: sum.x / sum.count, y: sum.y / sum.count };
}

/** @param {Pixels} pixels @param {{ x: number, y: number }} place @param {number} reach_px @returns {Pixels} */
function around({ width, data }, { x, y }, reach_px) {
  const side = 2 * reach_px + 1;
  const cut = new Uint8Array(4 * side * side);
  for (let row = 0; row < side; row++) {
    const from = 4 * ((Math.round(y) - reach_px + row) * width + Math.round(x) - reach_px);
    cut.set(data.subarray(from, from + 4 * side), 4 * side * row);
  }
  return { width: side, height: side, data: cut };
}
