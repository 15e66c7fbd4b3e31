//! Fine detail for areas that no photo shows, which would otherwise look too smooth next to the rest.

use glam::{Vec2, Vec3};

use crate::blend::Blend;
use crate::map::{AREA, CELLS, blurred, bytes, divided, ramp};
use crate::sampling::{Sample, bilinear, in_row, row_of};

/// Minimum presence of a cell as a source of detail.
const SEEN: f32 = 0.98;
/// Levels of [`blurred`] that smooth the position of the source.
const SMOOTH: u32 = 2;
/// Maximum distance of the source from the border, in cells.
const MAX_DEPTH: f32 = 18.0;
/// Differences between smoothed and actual border position over which the detail fades out, in cells.
const DISCONTINUITY: [f32; 2] = [0.7, 2.5];
/// Amplitude in levels beyond which detail is reduced, because it is a feature rather than grain.
const MAX_AMPLITUDE: f32 = 16.0;

/// Adds detail from nearby visible areas to texels that no photo shows.
pub(crate) fn add_grain(pixels: &mut [u8], blend: &Blend, positions: &[Sample]) {
    let side = positions.len();
    let drawn = pixels.to_vec();
    let drawn = drawn.as_chunks::<3>().0;
    let (slow, (from, amount)) = (slow(drawn, side), reflections(blend));
    let per_cell = side as f32 / CELLS as f32;
    let texel = |cells: f32| (((cells + 0.5) * per_cell).max(0.0) as usize).min(side - 1);
    let (mut row_from, mut row_amount) = (Vec::new(), Vec::new());
    for (row, pixels) in positions.iter().zip(pixels.chunks_mut(side * 3)) {
        row_of(&from, *row, &mut row_from);
        row_of(&amount, *row, &mut row_amount);
        for (column, pixel) in positions.iter().zip(pixels.as_chunks_mut::<3>().0) {
            let amount = in_row(&row_amount, *column);
            if amount > 0.0 {
                let from = in_row(&row_from, *column);
                let (x, y) = (texel(from.x), texel(from.y));
                let colour = Vec3::from(drawn[y * side + x].map(f32::from));
                let detail = grain(colour, bilinear(&slow, positions[x], positions[y]));
                *pixel = bytes(Vec3::from(pixel.map(f32::from)) + detail * amount);
            }
        }
    }
}

/// For each cell, the source of its detail, in cells, and the amount to add. The source is the cell's reflection at the
/// nearest visible cell, folded back at [`MAX_DEPTH`].
fn reflections(blend: &Blend) -> (Vec<Vec2>, Vec<f32>) {
    let nearest = nearest(&blend.presence);
    let ones = blurred(&vec![1.0; AREA], SMOOTH, CELLS);
    let smooth = blurred(&nearest, SMOOTH, CELLS);
    let reflected = |cell: usize| {
        let border = divided(smooth[cell], ones[cell]);
        let to_border = border - centre(cell);
        let distance = to_border.length();
        let turns = (distance / (2.0 * MAX_DEPTH)) as i32 as f32;
        let folded = MAX_DEPTH - (distance - 2.0 * MAX_DEPTH * turns - MAX_DEPTH).abs();
        // Halfway between two borders the nearest one changes abruptly; the detail fades out there.
        let jump = ramp(border.distance(nearest[cell]), DISCONTINUITY[0], DISCONTINUITY[1]);
        (border + to_border * divided(folded, distance), (1.0 - jump) * blend.missing[cell])
    };
    (0..AREA).map(reflected).unzip()
}

/// Low frequencies of a picture, per cell.
fn slow(pixels: &[[u8; 3]], side: usize) -> Vec<Vec3> {
    let per_cell = side / CELLS;
    let mut sums = vec![Vec3::ZERO; AREA];
    for (row, pixels) in pixels.chunks(side).enumerate() {
        for (sum, pixels) in sums[row / per_cell * CELLS..].iter_mut().zip(pixels.chunks(per_cell)) {
            pixels.iter().for_each(|pixel| *sum += Vec3::from(pixel.map(f32::from)));
        }
    }
    let means: Vec<Vec3> = sums.into_iter().map(|sum| divided(sum, (per_cell * per_cell) as f32)).collect();
    blurred(&means, 1, CELLS)
}

/// Difference between a colour and its low frequencies, limited in amplitude.
fn grain(colour: Vec3, slow: Vec3) -> Vec3 {
    let detail = colour - slow;
    detail * (MAX_AMPLITUDE * MAX_AMPLITUDE / (MAX_AMPLITUDE * MAX_AMPLITUDE + detail.length_squared()))
}

fn centre(cell: usize) -> Vec2 {
    Vec2::new((cell % CELLS) as f32, (cell / CELLS) as f32)
}

/// Nearest visible cell by sequential distance propagation (Danielsson 1980); a cell itself if none is visible.
fn nearest(presence: &[f32]) -> Vec<Vec2> {
    let mut nearest: Vec<Option<Vec2>> =
        presence.iter().enumerate().map(|(cell, seen)| (*seen >= SEEN).then(|| centre(cell))).collect();
    let mut propagate = |cell: usize, neighbours: [(isize, isize); 4]| {
        let (row, column) = (cell / CELLS, cell % CELLS);
        for (down, right) in neighbours {
            let (row, column) = (row.wrapping_add_signed(down), column.wrapping_add_signed(right));
            if row < CELLS && column < CELLS {
                let distance = |position: Option<Vec2>| {
                    position.map_or(f32::INFINITY, |position| position.distance_squared(centre(cell)))
                };
                let other = nearest[row * CELLS + column];
                if distance(other) < distance(nearest[cell]) {
                    nearest[cell] = other;
                }
            }
        }
    };
    // Two iterations, so that values also pass around corners.
    for _ in 0..2 {
        (0..AREA).for_each(|cell| propagate(cell, [(0, -1), (-1, -1), (-1, 0), (-1, 1)]));
        (0..AREA).rev().for_each(|cell| propagate(cell, [(0, 1), (1, 1), (1, 0), (1, -1)]));
    }
    nearest.into_iter().enumerate().map(|(cell, nearest)| nearest.unwrap_or(centre(cell))).collect()
}
