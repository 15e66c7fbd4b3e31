//! Backgrounds, and compositing of faces onto them.

use rosto_photo::Photo;

use super::Placement;
use crate::support::seeded::Seeded;

/// Background of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ground {
    Black,
    Grey,
    /// A linear gradient between two colours.
    Gradient,
    /// Random pixels.
    Noise,
    /// Soft spots of several sizes, like leaves out of focus.
    Clouds,
    /// Clouds with left–right symmetry, which can mislead a face detector.
    MirroredClouds,
    Stripes,
    /// The portrait's lower half, tiled.
    Cloth,
}

impl Ground {
    pub const ALL: [Self; 8] = [
        Self::Black,
        Self::Grey,
        Self::Gradient,
        Self::Noise,
        Self::Clouds,
        Self::MirroredClouds,
        Self::Stripes,
        Self::Cloth,
    ];

    /// A picture of the background alone.
    pub fn picture(self, width: u32, height: u32, seed: u64, portrait: &Photo) -> Photo {
        let clouds = Clouds::new(seed, f64::from(width.min(height)) / 5.0);
        let mut seeded = Seeded::new(seed);
        let mut pixels = Vec::with_capacity(width as usize * height as usize * 3);
        for y in 0..height {
            for x in 0..width {
                pixels.extend(match self {
                    Self::Black => [0; 3],
                    Self::Grey => [110, 120, 130],
                    Self::Gradient => [(x * 255 / width) as u8, (y * 255 / height) as u8, 90],
                    Self::Noise => seeded.bits().to_le_bytes()[..3].try_into().expect("eight bytes contain three"),
                    Self::Clouds => clouds.colour(x, y),
                    Self::MirroredClouds => clouds.colour(x.min(width - 1 - x), y),
                    Self::Stripes => [if (x + y / 2) % 64 < 32 { 200 } else { 60 }; 3],
                    Self::Cloth => portrait.pixel(folded(x, 512), 256 + folded(y, 256)),
                });
            }
        }
        Photo::from_rgb(width, height, pixels).expect("there are three bytes per pixel")
    }
}

/// Mirrored repetition, which is continuous at the seams.
fn folded(at: u32, extent: u32) -> u32 {
    let at = at % (2 * extent);
    at.min(2 * extent - 1 - at)
}

/// Value noise in several octaves, with smooth interpolation.
struct Clouds {
    seed: u64,
    coarsest_px: f64,
}

impl Clouds {
    fn new(seed: u64, coarsest_px: f64) -> Self {
        Self { seed, coarsest_px: coarsest_px.max(4.0) }
    }

    fn colour(&self, x: u32, y: u32) -> [u8; 3] {
        std::array::from_fn(|channel| {
            let octave = |n: u32| {
                let side = self.coarsest_px / f64::from(1 << n);
                self.value(f64::from(x) / side, f64::from(y) / side, u64::from(n) * 3 + channel as u64 % 2)
                    / f64::from(1 << n)
            };
            let sum: f64 = (0..4).map(octave).sum();
            (sum / 1.875 * 255.0).round().clamp(0.0, 255.0) as u8
        })
    }

    fn value(&self, x: f64, y: f64, layer: u64) -> f64 {
        let (left, top) = (x.floor(), y.floor());
        let smooth = |t: f64| t * t * (3.0 - 2.0 * t);
        let (fx, fy) = (smooth(x - left), smooth(y - top));
        let corner = |dx: u64, dy: u64| {
            let place = (left as u64 + dx) << 32 ^ (top as u64 + dy) << 8 ^ layer;
            (Seeded::new(self.seed ^ place).bits() >> 40) as f64 / f64::from(1 << 24)
        };
        let (upper, lower) =
            (corner(0, 0) * (1.0 - fx) + corner(1, 0) * fx, corner(0, 1) * (1.0 - fx) + corner(1, 1) * fx);
        upper * (1.0 - fy) + lower * fy
    }
}

/// Draws a part of `source` (left, top, width, height) onto `ground` at `placed`. Downscaling averages a grid of
/// samples.
pub fn put(ground: &mut [u8], width: u32, height: u32, source: &Photo, part: [u32; 4], placed: &Placement) {
    let samples = (1.0 / placed.scale).ceil().clamp(1.0, 16.0) as u32;
    let [left, top, part_width, part_height] = part.map(f64::from);
    let corners = [[0.0, 0.0], [part_width, 0.0], [0.0, part_height], [part_width, part_height]]
        .map(|[x, y]| placed.in_picture([left + x, top + y]));
    let range = |axis: usize, extent: u32| {
        let along = corners.iter().map(|corner| corner[axis]);
        let first = along.clone().fold(f64::INFINITY, f64::min).floor().clamp(0.0, f64::from(extent));
        let last = along.fold(f64::NEG_INFINITY, f64::max).ceil().clamp(-1.0, f64::from(extent) - 1.0);
        first as u32..(last + 1.0) as u32
    };
    for y in range(1, height) {
        for x in range(0, width) {
            let Some(colour) = mean_colour(source, part, placed, [f64::from(x), f64::from(y)], samples) else {
                continue;
            };
            let start = (y as usize * width as usize + x as usize) * 3;
            ground[start..start + 3].copy_from_slice(&colour);
        }
    }
}

fn mean_colour(source: &Photo, part: [u32; 4], placed: &Placement, at: [f64; 2], samples: u32) -> Option<[u8; 3]> {
    let [left, top, width, height] = part.map(f64::from);
    let [x, y] = placed.in_portrait(at);
    if !(left..=left + width - 1.0).contains(&x) || !(top..=top + height - 1.0).contains(&y) {
        return None;
    }
    let mut sums = [0.0; 3];
    for sample in 0..samples * samples {
        let part_of = |i: u32| (f64::from(i) + 0.5) / f64::from(samples) - 0.5;
        let [x, y] = placed.in_portrait([at[0] + part_of(sample % samples), at[1] + part_of(sample / samples)]);
        let colour = bilinear(source, x, y);
        (0..3).for_each(|channel| sums[channel] += colour[channel]);
    }
    Some(sums.map(|sum| (sum / f64::from(samples * samples)).round() as u8))
}

fn bilinear(photo: &Photo, x: f64, y: f64) -> [f64; 3] {
    let (x, y) = (x.clamp(0.0, f64::from(photo.width() - 1)), y.clamp(0.0, f64::from(photo.height() - 1)));
    let (left, top) = (x as u32, y as u32);
    let (fx, fy) = (x - f64::from(left), y - f64::from(top));
    let tap = |dx: u32, dy: u32| {
        photo.pixel((left + dx).min(photo.width() - 1), (top + dy).min(photo.height() - 1)).map(f64::from)
    };
    let (a, b, c, d) = (tap(0, 0), tap(1, 0), tap(0, 1), tap(1, 1));
    std::array::from_fn(|i| (a[i] * (1.0 - fx) + b[i] * fx) * (1.0 - fy) + (c[i] * (1.0 - fx) + d[i] * fx) * fy)
}
