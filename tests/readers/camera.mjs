// The camera that took the photo, from what a file tells of it: focal length, how the head is turned, and where the landmarks are
// in the photo.

/** @typedef {import("./shape.mjs").Point} Point */

/**
 * @param {{ focal_px: number, yaw_deg: number, pitch_deg: number, roll_deg: number }} about
 * @param {Point[]} positions_m of the landmarks in the model's frame
 * @param {[number, number][]} seen_px of the same in the photo, from its middle, y up
 */
export function cameraOf({ focal_px, ...pose }, positions_m, seen_px) {
  const rotation = rotationOf(pose);
  const turned = positions_m.map((point) => apply(rotation, point));
  const moved = translation(focal_px, turned, seen_px);
  const matrix = [...rotation.flatMap((row, at) => [...row, moved[at]]), 0, 0, 0, 1];
  const inCamera = turned.map((point) => point.map((value, axis) => value + moved[axis]));
  const errors_px = inCamera.map(([x, y, z], at) => Math.hypot((focal_px * x) / -z - seen_px[at][0], (focal_px * y) / -z - seen_px[at][1]));
  return { matrix, errors_px };
}

/** Yaw about +Y, then pitch about +X, then roll about +Z, each in the frame that the one before it left. */
function rotationOf({ yaw_deg, pitch_deg, roll_deg }) {
  const [yaw, pitch, roll] = [yaw_deg, pitch_deg, roll_deg].map((degrees) => (degrees * Math.PI) / 180);
  const about = {
    y: [[Math.cos(yaw), 0, Math.sin(yaw)], [0, 1, 0], [-Math.sin(yaw), 0, Math.cos(yaw)]],
    x: [[1, 0, 0], [0, Math.cos(pitch), -Math.sin(pitch)], [0, Math.sin(pitch), Math.cos(pitch)]],
    z: [[Math.cos(roll), -Math.sin(roll), 0], [Math.sin(roll), Math.cos(roll), 0], [0, 0, 1]],
  };
  return product(product(about.y, about.x), about.z);
}

/** Where the model's origin lies before the camera: what puts the landmarks on their rays, by least squares. */
function translation(focal_px, turned, seen_px) {
  const rows = turned.flatMap(([x, y, z], at) => {
    const [u, v] = seen_px[at];
    // u = −f (x + tx) / (z + tz), and v alike, times what is below the line.
    return [
      { of: [focal_px, 0, u], is: -u * z - focal_px * x },
      { of: [0, focal_px, v], is: -v * z - focal_px * y },
    ];
  });
  const normal = [0, 1, 2].map((i) => [0, 1, 2].map((j) => rows.reduce((sum, { of }) => sum + of[i] * of[j], 0)));
  const right = [0, 1, 2].map((i) => rows.reduce((sum, { of, is }) => sum + of[i] * is, 0));
  return solved(normal, right);
}

/** By Cramer's rule. @param {number[][]} matrix @param {number[]} right */
function solved(matrix, right) {
  const whole = determinant(matrix);
  return [0, 1, 2].map((column) => determinant(matrix.map((row, at) => row.with(column, right[at]))) / whole);
}

function determinant([a, b, c]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

function product(a, b) {
  return a.map((row) => [0, 1, 2].map((column) => row.reduce((sum, value, at) => sum + value * b[at][column], 0)));
}

function apply(matrix, point) {
  return matrix.map((row) => row.reduce((sum, value, at) => sum + value * point[at], 0));
}
