use std::ops::Range;

use glam::{DAffine2, DMat2, DVec2};
use rosto_photo::Photo;

use crate::Patch;
use crate::folds::doubled_area;

/// Less than this moves nothing, in px.
const LEAST_PX: f64 = 1e-4;

/// The picture with what is in the patch moved: each pixel takes the colour from where it came, by cubic interpolation
/// (Catmull–Rom), in sRGB. A pixel that does not move keeps its bytes.
pub fn drawn(photo: &Photo, patch: &Patch) -> Photo {
    let mut pixels = photo.pixels().to_vec();
    let sampler = Sampler::new(photo);
    for corners in &patch.triangles {
        let from = corners.map(|corner| patch.from_px[corner as usize]);
        let to = corners.map(|corner| patch.to_px[corner as usize]);
        if (0..3).any(|corner| from[corner].distance(to[corner]) > LEAST_PX) {
            draw_triangle(&sampler, from, to, &mut pixels);
        }
    }
    Photo::from_rgb(photo.width(), photo.height(), pixels).unwrap_or_else(|_| photo.clone())
}

fn draw_triangle(sampler: &Sampler<'_>, from: [DVec2; 3], to: [DVec2; 3], pixels: &mut [u8]) {
    let Some(from_to) = affine(to, from) else { return };
    let (low, high) = (to[0].min(to[1]).min(to[2]), to[0].max(to[1]).max(to[2]));
    for row in whole(low.y, high.y, sampler.height) {
        let y = row as f64 + 0.5;
        let Some((left, right)) = span(to, y) else { continue };
        let columns = whole(left, right, sampler.width);
        if columns.is_empty() {
            continue;
        }
        let start = from_to.transform_point2(DVec2::new(0.5, y));
        let row_pixels = &mut pixels[3 * (row * sampler.width + columns.start)..];
        for (column, pixel) in columns.zip(row_pixels.as_chunks_mut::<3>().0) {
            *pixel = sampler.colour_at(start + from_to.matrix2.x_axis * column as f64);
        }
    }
}

/// The pixels of a row or column whose middles lie between two places.
fn whole(low: f64, high: f64, count: usize) -> Range<usize> {
    let first = (low - 0.5).ceil().max(0.0);
    let beyond = (high + 0.5).floor().min(count as f64);
    first as usize..beyond.max(first) as usize
}

/// From where to where a horizontal line lies in a triangle.
fn span(corners: [DVec2; 3], y: f64) -> Option<(f64, f64)> {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (corners[a], corners[b])) {
        // From the top, so that both triangles at an edge cross it at the same place, to the last bit: no pixel is between.
        let (a, b) = if (a.y, a.x) < (b.y, b.x) { (a, b) } else { (b, a) };
        if a.y <= y && y <= b.y && a.y != b.y {
            let x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            ends = (ends.0.min(x), ends.1.max(x));
        }
    }
    (ends.0 <= ends.1).then_some(ends)
}

/// The affine map that takes one triangle to another; none from one without area.
fn affine(from: [DVec2; 3], to: [DVec2; 3]) -> Option<DAffine2> {
    if doubled_area(from) == 0.0 {
        return None;
    }
    let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
    let matrix = edges(to) * edges(from).inverse();
    let map = DAffine2::from_mat2_translation(matrix, to[0] - matrix * from[0]);
    map.is_finite().then_some(map)
}

/// Reads a picture between its pixels.
struct Sampler<'a> {
    pixels: &'a [u8],
    width: usize,
    height: usize,
}

/// Four pixels of a row.
type Four = [u8; 12];

impl<'a> Sampler<'a> {
    fn new(photo: &'a Photo) -> Self {
        Self { pixels: photo.pixels(), width: photo.width() as usize, height: photo.height() as usize }
    }

    /// The colour at a place, by a cubic through the four pixels around it each way; beyond the edge, the edge goes on.
    fn colour_at(&self, place: DVec2) -> [u8; 3] {
        let ((column, across), (row, down)) = (split(place.x - 0.5), split(place.y - 0.5));
        let (column, row) = (column - 1, row - 1);
        let is_inside = column >= 0 && row >= 0 && column + 4 <= self.width as i64 && row + 4 <= self.height as i64;
        let rows: [Four; 4] = match is_inside {
            true => std::array::from_fn(|j| self.four(column as usize, row as usize + j)),
            false => std::array::from_fn(|j| self.four_at_the_edge(column, row + j as i64)),
        };
        mixed(&rows, weights(across), weights(down))
    }

    #[inline]
    fn four(&self, column: usize, row: usize) -> Four {
        let start = 3 * (row * self.width + column);
        self.pixels[start..].first_chunk().copied().unwrap_or_default()
    }

    #[cold]
    fn four_at_the_edge(&self, column: i64, row: i64) -> Four {
        let row = row.clamp(0, self.height as i64 - 1) as usize;
        std::array::from_fn(|byte| {
            let column = (column + byte as i64 / 3).clamp(0, self.width as i64 - 1) as usize;
            self.pixels[3 * (row * self.width + column) + byte % 3]
        })
    }
}

/// The whole number below, and how far it is from there; processors without an instruction for it call a slow function.
#[inline]
fn split(place: f64) -> (i64, f32) {
    let towards_zero = place as i64;
    let below = towards_zero - i64::from(place < towards_zero as f64);
    (below, (place - below as f64) as f32)
}

/// First all rows into one, which is the same for each byte, then its four pixels. Plain loops become vector instructions.
#[inline]
fn mixed(rows: &[Four; 4], across: [f32; 4], down: [f32; 4]) -> [u8; 3] {
    let mut column = [0.0_f32; 12];
    for (row, weight) in rows.iter().zip(down) {
        for (sum, byte) in column.iter_mut().zip(row) {
            *sum += weight * f32::from(*byte);
        }
    }
    // Half up, and what is beyond 0 and 255 ends there.
    [0, 1, 2].map(|channel| {
        let sum = across[0] * column[channel]
            + across[1] * column[3 + channel]
            + across[2] * column[6 + channel]
            + across[3] * column[9 + channel];
        (sum + 0.5) as u8
    })
}

/// Catmull and Rom's weights of the four pixels around a place that is so far from the second to the third.
#[inline]
fn weights(share: f32) -> [f32; 4] {
    let t = share;
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3), 0.5 * (t3 - t2)]
}
