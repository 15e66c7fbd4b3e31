//! Resamples a region of the picture to a network's input, bit-identical to OpenCV's `warpPerspective`.
//!
//! The networks are sensitive to single pixels, so the order of the arithmetic matters: corners in f32, the homography
//! solved and inverted in f64, source positions rounded to 1/32 px, half to even. There is no half-pixel offset: the
//! region's corners map to tensor indices 0 and `side`.

use rosto_photo::Photo;

use crate::homography::{self, Matrix};
use crate::layers::widest;
use crate::region_of_interest::RegionPx;

/// Colour outside the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outside {
    /// Black.
    Zero,
    /// The nearest pixel of the picture.
    NearestEdge,
}

/// Writes the region as three planes (red, green, blue) of `side × side` values `scale · u8 + offset`.
pub(crate) fn fill_planes(
    planes: &mut [f32],
    photo: &Photo,
    region: &RegionPx,
    outside: Outside,
    [scale, offset]: [f32; 2],
) {
    let side = (planes.len() / 3).isqrt();
    widest(
        #[inline(always)]
        || {
            for_each_sample(photo, region, side, outside, |index, rgb| {
                for (channel, value) in rgb.into_iter().enumerate() {
                    planes[channel * side * side + index] = f32::from(value) * scale + offset;
                }
            });
        },
    );
}

/// Block width after which OpenCV restarts its running sums along a row.
const BLOCK: usize = 64;
/// Number of source positions per pixel.
const STEPS: i32 = 1 << STEPS_LOG2;
const STEPS_LOG2: u32 = 5;

/// Calls `visit(index, rgb)` for each pixel of the `side × side` result in row-major order.
#[inline(always)]
fn for_each_sample(
    photo: &Photo,
    region: &RegionPx,
    side: usize,
    outside: Outside,
    mut visit: impl FnMut(usize, [u8; 3]),
) {
    let m = source_from_tensor(region, side);
    let sampler = Sampler::new(photo, outside);
    for y in 0..side {
        for block in (0..side).step_by(BLOCK) {
            let [xs, ys] = positions(&m, block, y);
            for (step, (&x, &y_source)) in xs.iter().zip(&ys).take(side - block).enumerate() {
                visit(y * side + block + step, sampler.sample(x, y_source));
            }
        }
    }
}

/// Source positions of a block's pixels, in steps. Computed before sampling, so that the divisions vectorise.
#[inline(always)]
fn positions(m: &Matrix, block: usize, y: usize) -> [[i32; BLOCK]; 2] {
    let [start_x, start_y, start_w] = [0, 1, 2].map(|row| m[row][0] * block as f64 + m[row][1] * y as f64 + m[row][2]);
    let mut positions = [[0; BLOCK]; 2];
    let [xs, ys] = &mut positions;
    for (step, (x, y)) in xs.iter_mut().zip(ys).enumerate() {
        let step = step as f64;
        let w = start_w + m[2][0] * step;
        let w = if w == 0.0 { 0.0 } else { f64::from(STEPS) / w };
        *x = ((start_x + m[0][0] * step) * w).round_ties_even() as i32;
        *y = ((start_y + m[1][0] * step) * w).round_ties_even() as i32;
    }
    positions
}

fn source_from_tensor(region: &RegionPx, side: usize) -> Matrix {
    let side = side as f32;
    let tensor_corners = [[0.0, side], [0.0, 0.0], [side, 0.0], [side, side]];
    homography::inverse(&homography::between(&corners(region), &tensor_corners))
}

/// Bottom left, top left, top right, bottom right.
fn corners(region: &RegionPx) -> [[f32; 2]; 4] {
    let ([x, y], [width, height]) = (region.centre, region.size);
    let degrees = (f64::from(region.rotation_rad * 180.0) / std::f64::consts::PI) as f32;
    let angle = f64::from(degrees) * std::f64::consts::PI / 180.0;
    let (b, a) = (angle.cos() as f32 * 0.5, angle.sin() as f32 * 0.5);
    let bottom_left = [x - a * height - b * width, y + b * height - a * width];
    let top_left = [x + a * height - b * width, y - b * height - a * width];
    let opposite = |[px, py]: [f32; 2]| [2.0 * x - px, 2.0 * y - py];
    [bottom_left, top_left, opposite(bottom_left), opposite(top_left)]
}

/// Fixed-point bilinear sampling.
struct Sampler<'a> {
    bytes: &'a [u8],
    width: i32,
    height: i32,
    outside: Outside,
}

/// Red, green, blue and a padding element, to fill a vector.
type Tap = [u32; 4];

impl<'a> Sampler<'a> {
    fn new(photo: &'a Photo, outside: Outside) -> Self {
        Self { bytes: photo.pixels(), width: photo.width() as i32, height: photo.height() as i32, outside }
    }

    /// The colour at (`x`, `y`), in steps: `(Σ p·wx·wy + 512) >> 10` for each channel.
    #[inline(always)]
    fn sample(&self, x: i32, y: i32) -> [u8; 3] {
        let (fx, fy) = ((x & (STEPS - 1)) as u32, (y & (STEPS - 1)) as u32);
        let taps = self.taps(x >> STEPS_LOG2, y >> STEPS_LOG2);
        let weights = [(32 - fx) * (32 - fy), fx * (32 - fy), (32 - fx) * fy, fx * fy];
        let mut sums = [512; 4];
        for (tap, weight) in taps.iter().zip(weights) {
            for (sum, value) in sums.iter_mut().zip(tap) {
                *sum += value * weight;
            }
        }
        let [red, green, blue, _] = sums.map(|sum| (sum >> 10) as u8);
        [red, green, blue]
    }

    /// The pixel at (`x`, `y`), its right neighbour, and the two below.
    #[inline(always)]
    fn taps(&self, x: i32, y: i32) -> [Tap; 4] {
        // The fast path reads 7 bytes per row, which exceeds the buffer at the last pixels.
        if x < 0 || y < 0 || x >= self.width - 1 || y >= self.height - 2 {
            return [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| self.tap(x, y));
        }
        let row = self.width as usize * 3;
        let start = y as usize * row + x as usize * 3;
        let (above, below) = (&self.bytes[start..][..7], &self.bytes[start + row..][..7]);
        let tap = |bytes: &[u8], first: usize| std::array::from_fn(|channel| u32::from(bytes[first + channel]));
        [tap(above, 0), tap(above, 3), tap(below, 0), tap(below, 3)]
    }

    #[cold]
    fn tap(&self, x: i32, y: i32) -> Tap {
        let (nearest_x, nearest_y) = (x.clamp(0, self.width - 1), y.clamp(0, self.height - 1));
        if self.outside == Outside::Zero && (nearest_x, nearest_y) != (x, y) {
            return [0; 4];
        }
        let start = (nearest_y as usize * self.width as usize + nearest_x as usize) * 3;
        [self.bytes[start], self.bytes[start + 1], self.bytes[start + 2], 0].map(u32::from)
    }
}
