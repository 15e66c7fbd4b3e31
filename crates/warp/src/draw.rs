use std::ops::RangeInclusive;

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
    let size = [photo.width() as usize, photo.height() as usize];
    for corners in &patch.triangles {
        let from = corners.map(|corner| patch.from_px[corner as usize]);
        let to = corners.map(|corner| patch.to_px[corner as usize]);
        if (0..3).any(|corner| from[corner].distance(to[corner]) > LEAST_PX) {
            draw_triangle(photo, size, from, to, &mut pixels);
        }
    }
    Photo::from_rgb(photo.width(), photo.height(), pixels).unwrap_or_else(|_| photo.clone())
}

fn draw_triangle(photo: &Photo, [width, height]: [usize; 2], from: [DVec2; 3], to: [DVec2; 3], pixels: &mut [u8]) {
    let Some(from_to) = affine(to, from) else { return };
    let (low, high) = (to[0].min(to[1]).min(to[2]), to[0].max(to[1]).max(to[2]));
    for row in whole(low.y, high.y, height) {
        let Some((left, right)) = span(to, row as f64 + 0.5) else { continue };
        for column in whole(left, right, width) {
            let place = from_to.transform_point2(DVec2::new(column as f64 + 0.5, row as f64 + 0.5));
            let at = 3 * (row * width + column);
            pixels[at..at + 3].copy_from_slice(&colour_at(photo, place));
        }
    }
}

/// The pixels of a row or column whose middles lie between two places.
fn whole(low: f64, high: f64, count: usize) -> RangeInclusive<usize> {
    let first = (low - 0.5).ceil().max(0.0);
    let last = (high - 0.5).floor().min(count as f64 - 1.0);
    if first <= last { first as usize..=last as usize } else { 1..=0 }
}

/// From where to where a horizontal line lies in a triangle.
fn span(corners: [DVec2; 3], y: f64) -> Option<(f64, f64)> {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (corners[a], corners[b])) {
        if a.y.min(b.y) <= y && y <= a.y.max(b.y) && a.y != b.y {
            let x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            ends = (ends.0.min(x), ends.1.max(x));
        }
    }
    (ends.0 <= ends.1).then_some(ends)
}

/// The affine map that takes one triangle to another; none from one without area.
fn affine(from: [DVec2; 3], to: [DVec2; 3]) -> Option<DAffine2> {
    let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
    let matrix = edges(to) * edges(from).inverse();
    let map = DAffine2::from_mat2_translation(matrix, to[0] - matrix * from[0]);
    (doubled_area(from) != 0.0 && map.is_finite()).then_some(map)
}

/// The colour at a place, by a cubic through the four pixels around it each way; beyond the edge, the edge goes on.
fn colour_at(photo: &Photo, place: DVec2) -> [u8; 3] {
    let corner = (place - 0.5).floor();
    let share = place - 0.5 - corner;
    let (across, down) = (weights(share.x), weights(share.y));
    let (width, height) = (photo.width() as i64, photo.height() as i64);
    let (column, row) = (corner.x as i64 - 1, corner.y as i64 - 1);
    let columns: [usize; 4] = std::array::from_fn(|i| 3 * (column + i as i64).clamp(0, width - 1) as usize);
    let mut sum = [0.0_f32; 3];
    for (j, by_row) in down.iter().enumerate() {
        let start = 3 * ((row + j as i64).clamp(0, height - 1) * width) as usize;
        for (i, by_column) in across.iter().enumerate() {
            let at = start + columns[i];
            let weight = by_row * by_column;
            let pixel = &photo.pixels()[at..at + 3];
            (0..3).for_each(|channel| sum[channel] += weight * f32::from(pixel[channel]));
        }
    }
    sum.map(|value| value.round() as u8)
}

/// Catmull and Rom's weights of the four pixels around a place that is so far from the second to the third.
fn weights(share: f64) -> [f32; 4] {
    let t = share;
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3), 0.5 * (t3 - t2)]
        .map(|weight| weight as f32)
}
