use std::ops::Range;

use glam::{DAffine2, DMat2, DVec2};
use rosto_photo::{Photo, Sampler};

use crate::WarpMesh;
use crate::folds::doubled_area;

/// Displacements below this are ignored, in px.
const MIN_DISPLACEMENT_PX: f64 = 1e-4;

/// Warps a picture. Each pixel takes the colour at its source position, interpolated by Catmull–Rom cubics in sRGB.
/// Pixels that do not move keep their bytes. The alpha channel is warped alike.
pub fn drawn(photo: &Photo, warp_mesh: &WarpMesh) -> Photo {
    let moved = drawn_opaque(photo, warp_mesh);
    let Some(alpha) = photo.alpha() else { return moved };
    let grey = alpha.iter().flat_map(|&alpha| [alpha; 3]).collect();
    let moved_alpha = Photo::from_rgb(photo.width(), photo.height(), grey).map(|grey| drawn_opaque(&grey, warp_mesh));
    let alpha = moved_alpha.map(|grey| grey.pixels().iter().step_by(3).copied().collect());
    alpha.and_then(|alpha| moved.with_alpha(alpha)).unwrap_or_else(|_| photo.clone())
}

fn drawn_opaque(photo: &Photo, warp_mesh: &WarpMesh) -> Photo {
    let mut pixels = photo.pixels().to_vec();
    let (sampler, size) = (Sampler::new(photo), [photo.width(), photo.height()].map(|side| side as usize));
    for corners in &warp_mesh.triangles {
        let from = corners.map(|corner| warp_mesh.from_px[corner as usize]);
        let to = corners.map(|corner| warp_mesh.to_px[corner as usize]);
        if (0..3).any(|corner| from[corner].distance(to[corner]) > MIN_DISPLACEMENT_PX) {
            draw_triangle(&sampler, size, from, to, &mut pixels);
        }
    }
    Photo::from_rgb(photo.width(), photo.height(), pixels).unwrap_or_else(|_| photo.clone())
}

fn draw_triangle(
    sampler: &Sampler<'_>,
    [width, height]: [usize; 2],
    from: [DVec2; 3],
    to: [DVec2; 3],
    pixels: &mut [u8],
) {
    let Some(from_to) = affine(to, from) else { return };
    let (low, high) = (to[0].min(to[1]).min(to[2]), to[0].max(to[1]).max(to[2]));
    for row in whole(low.y, high.y, height) {
        let y = row as f64 + 0.5;
        let Some((left, right)) = span(to, y) else { continue };
        let columns = whole(left, right, width);
        if columns.is_empty() {
            continue;
        }
        let start = from_to.transform_point2(DVec2::new(0.5, y));
        let row_pixels = &mut pixels[3 * (row * width + columns.start)..];
        for (column, pixel) in columns.zip(row_pixels.as_chunks_mut::<3>().0) {
            // Rounds half up; the cast saturates.
            *pixel = sampler.at(start + from_to.matrix2.x_axis * column as f64).map(|level| (level + 0.5) as u8);
        }
    }
}

/// Indices of the pixels whose centres lie between two coordinates.
fn whole(low: f64, high: f64, count: usize) -> Range<usize> {
    let first = (low - 0.5).ceil().max(0.0);
    let beyond = (high + 0.5).floor().min(count as f64);
    first as usize..beyond.max(first) as usize
}

/// Intersection of a horizontal line with a triangle.
fn span(corners: [DVec2; 3], y: f64) -> Option<(f64, f64)> {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (corners[a], corners[b])) {
        // Top to bottom, so that the triangles on both sides of an edge compute the same intersection and leave no gap.
        let (a, b) = if (a.y, a.x) < (b.y, b.x) { (a, b) } else { (b, a) };
        if a.y <= y && y <= b.y && a.y != b.y {
            let x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            ends = (ends.0.min(x), ends.1.max(x));
        }
    }
    (ends.0 <= ends.1).then_some(ends)
}

/// Affine map from one triangle to another; `None` if the first has no area.
fn affine(from: [DVec2; 3], to: [DVec2; 3]) -> Option<DAffine2> {
    if doubled_area(from) == 0.0 {
        return None;
    }
    let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
    let matrix = edges(to) * edges(from).inverse();
    let map = DAffine2::from_mat2_translation(matrix, to[0] - matrix * from[0]);
    map.is_finite().then_some(map)
}
