// A video of the sample portrait's head over a still background, frame by frame. Works in pages and in Node, so that
// both get the same pixels.

export const WIDTH_PX = 640;
export const HEIGHT_PX = 480;
export const FRAMES_PER_S = 30;

/** Centre of the face in the portrait, and the box around the head, px. */
const MIDDLE = [224, 124];
const HEAD = { left: 124, top: 0, right: 323, bottom: 235 };

/** Amplitude of the camera noise, of 255. */
const NOISE = 8;

/** Number of frames before the face moves. */
export const STILL_FRAMES = 60;
export const SPEED_PX_S = 200;
/** Maximum distance of the face from the centre. */
const REACH_PX = 100;
/** Number of frames of one period. */
export const FRAMES = STILL_FRAMES + Math.round((4 * REACH_PX * FRAMES_PER_S) / SPEED_PX_S);

/** Squares in the corner that encode the frame's number: black for 0, white for 1, least significant bit first. */
const SQUARE = { side_px: 24, apart_px: 32, left_px: 8, top_px: 448, count: 8 };

/**
 * Pose of the face: `frame = at + scale · R(degrees) · (portrait − MIDDLE)`, with integer coordinates at pixel centres.
 *
 * @typedef {{ x: number, y: number, scale: number, degrees: number }} Place
 */
/** @typedef {{ width: number, height: number, data: ArrayLike<number> }} Picture RGBA */

/**
 * Pose in the camera's video: at rest, then right, left and back at constant speed; the video loops seamlessly.
 *
 * @returns {Place}
 */
export function poseIn(number) {
  const way = Math.max(0, (number % FRAMES) - STILL_FRAMES) * (SPEED_PX_S / FRAMES_PER_S);
  const aside = way < REACH_PX ? way : way < 3 * REACH_PX ? 2 * REACH_PX - way : way - 4 * REACH_PX;
  return { x: WIDTH_PX / 2 + aside, y: HEIGHT_PX / 2, scale: 1.6, degrees: 0 };
}

/** Speed to the right in px per frame; 0 where the motion turns. @param {number} number */
export function speedIn(number) {
  const [before, here, after] = [number - 1, number, number + 1].map((each) => poseIn((each + FRAMES) % FRAMES).x);
  return Math.abs(here - before - (after - here)) < 1e-6 ? here - before : 0;
}

/** Maps a point of the portrait, px, to a frame. @param {Place} place @param {number[]} point x, y */
export function mapToFrame({ x, y, scale, degrees }, [px, py]) {
  const [cos, sin] = turn(degrees);
  const [dx, dy] = [px - MIDDLE[0], py - MIDDLE[1]];
  return [x + scale * (cos * dx - sin * dy), y + scale * (sin * dx + cos * dy)];
}

/**
 * Renders a frame as RGBA, with its number in the corner. The number also seeds the noise.
 *
 * @param {Picture} portrait
 * @param {Place} place
 */
export function frameOf(portrait, place, number) {
  const data = new Uint8ClampedArray(4 * WIDTH_PX * HEIGHT_PX);
  const [cos, sin] = turn(place.degrees);
  const noise = noiseOf(number + 1);
  for (let y = 0, at = 0; y < HEIGHT_PX; y += 1) {
    for (let x = 0; x < WIDTH_PX; x += 1, at += 4) {
      const [dx, dy] = [(x - place.x) / place.scale, (y - place.y) / place.scale];
      put(data, at, portrait, MIDDLE[0] + cos * dx + sin * dy, MIDDLE[1] - sin * dx + cos * dy);
      if (data[at + 3] === 0) data.set([(x * 255) / WIDTH_PX, (y * 255) / HEIGHT_PX, 90, 255], at);
      for (let channel = 0; channel < 3; channel += 1) data[at + channel] += NOISE * (2 * noise() - 1);
    }
  }
  for (let bit = 0; bit < SQUARE.count; bit += 1) paint(data, bit, (number >> bit) & 1 ? 255 : 0);
  return data;
}

/** Reads the number in the corner of a frame. @param {Picture} frame */
export function numberOf(frame) {
  const scale = frame.width / WIDTH_PX;
  let number = 0;
  for (let bit = 0; bit < SQUARE.count; bit += 1) {
    const [x, y] = [SQUARE.left_px + bit * SQUARE.apart_px, SQUARE.top_px].map((side) => side + SQUARE.side_px / 2);
    const at = 4 * (Math.floor(y * scale) * frame.width + Math.floor(x * scale));
    if (frame.data[at + 1] > 127) number |= 1 << bit;
  }
  return number;
}

/** Pseudo-random values from 0 to 1 (mulberry32), reproducible on each platform. @param {number} seed */
function noiseOf(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Samples the head bilinearly. */
function put(data, at, { width, data: source }, x, y) {
  if (x < HEAD.left || y < HEAD.top || x > HEAD.right || y > HEAD.bottom) return;
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const [fx, fy] = [x - left, y - top];
  const start = 4 * (top * width + left);
  for (let channel = 0; channel < 4; channel += 1) {
    const tap = (dx, dy) => source[start + channel + 4 * (dy * width + dx)];
    const upper = tap(0, 0) * (1 - fx) + tap(1, 0) * fx;
    data[at + channel] = upper * (1 - fy) + (tap(0, 1) * (1 - fx) + tap(1, 1) * fx) * fy;
  }
}

function paint(data, bit, value) {
  for (let y = 0; y < SQUARE.side_px; y += 1) {
    for (let x = 0; x < SQUARE.side_px; x += 1) {
      const at = 4 * ((SQUARE.top_px + y) * WIDTH_PX + SQUARE.left_px + bit * SQUARE.apart_px + x);
      data.fill(value, at, at + 3);
    }
  }
}

/** Rounded, because mathematics libraries differ in the last digits. */
function turn(degrees) {
  const rounded = (value) => Math.round(value * 65_536) / 65_536;
  const radians = (degrees * Math.PI) / 180;
  return [rounded(Math.cos(radians)), rounded(Math.sin(radians))];
}
