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
            let source_from_tensor = source_from_tensor(region, side);
            let sampler = Sampler::new(photo, outside);
            let (mut taps, mut values) = (Taps::default(), [0.0; BLOCK]);
            for y in 0..side {
                for x in (0..side).step_by(BLOCK) {
                    let count = BLOCK.min(side - x);
                    let [xs, ys] = positions(&source_from_tensor, x, y);
                    sampler.gather([&xs[..count], &ys[..count]], &mut taps);
                    for (channel, plane) in planes.chunks_exact_mut(side * side).enumerate() {
                        taps.blend(8 * channel as u32, &mut values);
                        let out = plane[y * side + x..][..count].iter_mut().zip(&values);
                        out.for_each(|(out, value)| *out = value * scale + offset);
                    }
                }
            }
        },
    );
}

/// Block width after which OpenCV restarts its running sums along a row.
const BLOCK: usize = 64;
/// Number of source positions per pixel.
const STEPS: i32 = 1 << STEPS_LOG2;
const STEPS_LOG2: u32 = 5;

/// One number for each pixel of a block.
type Block<T> = [T; BLOCK];

/// Source positions of a block's pixels, in steps. Computed before sampling, so that the divisions vectorise.
#[inline(always)]
fn positions(m: &Matrix, block: usize, y: usize) -> [Block<i32>; 2] {
    let [start_x, start_y, start_w] = [0, 1, 2].map(|row| m[row][0] * block as f64 + m[row][1] * y as f64 + m[row][2]);
    let mut positions = [[0; BLOCK]; 2];
    let [xs, ys] = &mut positions;
    for (step, (x, y)) in xs.iter_mut().zip(ys).enumerate() {
        let step = step as f64;
        let w = start_w + m[2][0] * step;
        let w = if w == 0.0 { 0.0 } else { f64::from(STEPS) / w };
        *x = rounded((start_x + m[0][0] * step) * w);
        *y = rounded((start_y + m[1][0] * step) * w);
    }
    positions
}

/// Rounds half to even, and limits the number to far outside any picture. Vectorises, unlike a cast: the sum has no
/// fractional bits, and its lowest bits are the rounded number.
#[inline(always)]
fn rounded(number: f64) -> i32 {
    const FAR: f64 = 1e9;
    const WITHOUT_FRACTION: f64 = 1.5 * (1_u64 << 52) as f64;
    let number = if number > -FAR { number } else { -FAR };
    let number = if number < FAR { number } else { FAR };
    (number + WITHOUT_FRACTION).to_bits() as i32
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

/// The pixels of the picture that a block samples, with red in the lowest byte: at the position, its right neighbour, and
/// the two below. Gathered before they are blended, so that the blending vectorises.
struct Taps {
    pixels: [Block<u32>; 4],
    /// The position between the pixels, in steps.
    fractions: [Block<u32>; 2],
}

impl Default for Taps {
    fn default() -> Self {
        Self { pixels: [[0; BLOCK]; 4], fractions: [[0; BLOCK]; 2] }
    }
}

impl Taps {
    /// Interpolates the channel that begins at bit `shift`: `(Σ p·wx·wy + 512) >> 10`.
    #[inline(always)]
    fn blend(&self, shift: u32, values: &mut Block<f32>) {
        let ([above, above_right, below, below_right], [fxs, fys]) = (&self.pixels, &self.fractions);
        for (at, value) in values.iter_mut().enumerate() {
            let channel = |pixels: &Block<u32>| pixels[at] >> shift & 0xFF;
            let (fx, fy) = (fxs[at], fys[at]);
            let upper = channel(above) * (32 - fx) + channel(above_right) * fx;
            let lower = channel(below) * (32 - fx) + channel(below_right) * fx;
            *value = ((upper * (32 - fy) + lower * fy + 512) >> 10) as i32 as f32;
        }
    }
}

/// Pixels for fixed-point bilinear sampling.
struct Sampler<'a> {
    bytes: &'a [u8],
    width: i32,
    height: i32,
    outside: Outside,
}

impl<'a> Sampler<'a> {
    fn new(photo: &'a Photo, outside: Outside) -> Self {
        Self { bytes: photo.pixels(), width: photo.width() as i32, height: photo.height() as i32, outside }
    }

    /// Gathers the pixels for positions in steps.
    #[inline(always)]
    fn gather(&self, [xs, ys]: [&[i32]; 2], taps: &mut Taps) {
        for (at, (&x, &y)) in xs.iter().zip(ys).enumerate().take(BLOCK) {
            let pixels = self.pixels(x >> STEPS_LOG2, y >> STEPS_LOG2);
            taps.pixels.iter_mut().zip(pixels).for_each(|(taps, pixel)| taps[at] = pixel);
            taps.fractions[0][at] = (x & (STEPS - 1)) as u32;
            taps.fractions[1][at] = (y & (STEPS - 1)) as u32;
        }
    }

    /// The pixel at (`x`, `y`), its right neighbour, and the two below.
    #[inline(always)]
    fn pixels(&self, x: i32, y: i32) -> [u32; 4] {
        // The fast path reads 7 bytes per row, which exceeds the buffer at the last pixels.
        if x < 0 || y < 0 || x >= self.width - 1 || y >= self.height - 2 {
            return [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(|(x, y)| self.pixel(x, y));
        }
        let row = self.width as usize * 3;
        let start = y as usize * row + x as usize * 3;
        let (above, below) = (&self.bytes[start..][..7], &self.bytes[start + row..][..7]);
        let pixel = |bytes: &[u8], first: usize| {
            u32::from_le_bytes([bytes[first], bytes[first + 1], bytes[first + 2], bytes[first + 3]])
        };
        [pixel(above, 0), pixel(above, 3), pixel(below, 0), pixel(below, 3)]
    }

    #[cold]
    fn pixel(&self, x: i32, y: i32) -> u32 {
        let (nearest_x, nearest_y) = (x.clamp(0, self.width - 1), y.clamp(0, self.height - 1));
        if self.outside == Outside::Zero && (nearest_x, nearest_y) != (x, y) {
            return 0;
        }
        let start = (nearest_y as usize * self.width as usize + nearest_x as usize) * 3;
        u32::from_le_bytes([self.bytes[start], self.bytes[start + 1], self.bytes[start + 2], 0])
    }
}
