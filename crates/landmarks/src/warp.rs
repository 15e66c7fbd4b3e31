//! A region of the picture, resampled to a network's input, bit for bit as OpenCV's `warpPerspective` does it.
//!
//! The networks answer to the pixels they see, so the order of the arithmetic matters: the corners in f32, the
//! homography solved and inverted in f64, source positions rounded to 1/32 px, half to even. There is no half-pixel
//! offset: the region's corners map to tensor index 0 and `side`.

use rosto_photo::Photo;

use crate::homography::{self, Matrix};
use crate::region_of_interest::RegionPx;

/// What lies outside the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outside {
    /// Black.
    Zero,
    /// The nearest pixel of the picture.
    NearestEdge,
}

/// Writes the region as three planes (red, green, blue) of `side × side` values, `scale · u8 + offset`.
pub(crate) fn fill_planes(
    planes: &mut [f32],
    photo: &Photo,
    region: &RegionPx,
    outside: Outside,
    [scale, offset]: [f32; 2],
) {
    let side = (planes.len() / 3).isqrt();
    for_each_sample(photo, region, side, outside, |index, rgb| {
        for (channel, value) in rgb.into_iter().enumerate() {
            planes[channel * side * side + index] = f32::from(value) * scale + offset;
        }
    });
}

/// OpenCV walks along a row in blocks of this width and restarts its sums at each.
const BLOCK: usize = 64;
/// Positions are rounded to this fraction of a pixel.
const STEPS: i64 = 32;

/// Calls `visit(index, rgb)` for each pixel of the `side × side` result in row-major order.
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
        for x in 0..side {
            let (block, step) = ((x - x % BLOCK) as f64, (x % BLOCK) as f64);
            let start = |row: usize| m[row][0] * block + m[row][1] * y as f64 + m[row][2];
            let w = start(2) + m[2][0] * step;
            let w = if w == 0.0 { 0.0 } else { STEPS as f64 / w };
            let position = |row: usize| ((start(row) + m[row][0] * step) * w).round_ties_even() as i64;
            visit(y * side + x, sampler.sample(position(0), position(1)));
        }
    }
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
    pixels: &'a [u8],
    width: i64,
    height: i64,
    outside: Outside,
}

impl<'a> Sampler<'a> {
    fn new(photo: &'a Photo, outside: Outside) -> Self {
        Self { pixels: photo.pixels(), width: photo.width().into(), height: photo.height().into(), outside }
    }

    /// The colour at (`x`, `y`) in 1/32 px: `(Σ p·wx·wy + 512) >> 10` for each channel.
    fn sample(&self, x: i64, y: i64) -> [u8; 3] {
        let (x0, y0) = (x.div_euclid(STEPS), y.div_euclid(STEPS));
        let (fx, fy) = (x.rem_euclid(STEPS) as u32, y.rem_euclid(STEPS) as u32);
        let taps = [
            (self.tap(x0, y0), (32 - fx) * (32 - fy)),
            (self.tap(x0 + 1, y0), fx * (32 - fy)),
            (self.tap(x0, y0 + 1), (32 - fx) * fy),
            (self.tap(x0 + 1, y0 + 1), fx * fy),
        ];
        [0, 1, 2].map(|channel| {
            let sum: u32 = taps.iter().map(|(rgb, weight)| u32::from(rgb[channel]) * weight).sum();
            ((sum + 512) >> 10) as u8
        })
    }

    fn tap(&self, x: i64, y: i64) -> [u8; 3] {
        let (nearest_x, nearest_y) = (x.clamp(0, self.width - 1), y.clamp(0, self.height - 1));
        if self.outside == Outside::Zero && (nearest_x, nearest_y) != (x, y) {
            return [0; 3];
        }
        let start = (nearest_y * self.width + nearest_x) as usize * 3;
        [self.pixels[start], self.pixels[start + 1], self.pixels[start + 2]]
    }
}
