//! Detail for what no photo shows: skin without pores looks like wax beside skin.

use glam::{Vec2, Vec3};

use crate::between::{Place, between, in_row, row_of};
use crate::blend::Blend;
use crate::map::{AREA, CELLS, blurred, bytes, divided, ramp};

/// Detail is taken from where at least so much is seen.
const SEEN: f32 = 0.98;
/// Where it is taken from changes as smoothly as this blur: [`blurred`]'s times.
const SMOOTH: u32 = 2;
/// And from no further inside than this, in cells.
const REACH: f32 = 18.0;
/// Where that changes by so many cells and more, less and none is taken.
const TORN: [f32; 2] = [0.7, 2.5];
/// Detail by more levels than this is a feature and no grain: the more so, the less is taken of it.
const MOST: f32 = 16.0;

/// Gives what is not seen the detail of what is beside it.
pub(crate) fn add_grain(pixels: &mut [u8], blend: &Blend, places: &[Place]) {
    let side = places.len();
    let drawn = pixels.to_vec();
    let drawn = drawn.as_chunks::<3>().0;
    let (slow, (from, amount)) = (slow(drawn, side), reflections(blend));
    let per_cell = side as f32 / CELLS as f32;
    let texel = |cells: f32| (((cells + 0.5) * per_cell).max(0.0) as usize).min(side - 1);
    let (mut row_from, mut row_amount) = (Vec::new(), Vec::new());
    for (row, pixels) in places.iter().zip(pixels.chunks_mut(side * 3)) {
        row_of(&from, *row, &mut row_from);
        row_of(&amount, *row, &mut row_amount);
        for (column, pixel) in places.iter().zip(pixels.as_chunks_mut::<3>().0) {
            let amount = in_row(&row_amount, *column);
            if amount > 0.0 {
                let from = in_row(&row_from, *column);
                let (x, y) = (texel(from.x), texel(from.y));
                let colour = Vec3::from(drawn[y * side + x].map(f32::from));
                let detail = grain(colour, between(&slow, places[x], places[y]));
                *pixel = bytes(Vec3::from(pixel.map(f32::from)) + detail * amount);
            }
        }
    }
}

/// Where each cell's detail is reflected from, in cells, and how much of it is missing and can be taken: from the mirror image of its place in
/// the nearest cell that is seen, and back again where that would be further away than [`REACH`].
fn reflections(blend: &Blend) -> (Vec<Vec2>, Vec<f32>) {
    let nearest = nearest(&blend.presence);
    let ones = blurred(&vec![1.0; AREA], SMOOTH, CELLS);
    let smooth = blurred(&nearest, SMOOTH, CELLS);
    let reflected = |cell: usize| {
        let border = divided(smooth[cell], ones[cell]);
        let way = border - middle(cell);
        let far = way.length();
        let turns = (far / (2.0 * REACH)) as i32 as f32;
        let folded = REACH - (far - 2.0 * REACH * turns - REACH).abs();
        // Half-way between two borders the nearest one changes all at once, and the detail would be torn.
        let torn = ramp(border.distance(nearest[cell]), TORN[0], TORN[1]);
        (border + way * divided(folded, far), (1.0 - torn) * blend.missing[cell])
    };
    (0..AREA).map(reflected).unzip()
}

/// What is slow in a picture, for each cell.
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

/// Only what is grain of the difference between a colour and what is slow in it.
fn grain(colour: Vec3, slow: Vec3) -> Vec3 {
    let detail = colour - slow;
    detail * (MOST * MOST / (MOST * MOST + detail.length_squared()))
}

fn middle(cell: usize) -> Vec2 {
    Vec2::new((cell % CELLS) as f32, (cell / CELLS) as f32)
}

/// The nearest cell that is seen, by passing it on from cell to cell (Danielsson 1980); each its own where none is.
fn nearest(presence: &[f32]) -> Vec<Vec2> {
    let mut nearest: Vec<Option<Vec2>> =
        presence.iter().enumerate().map(|(cell, seen)| (*seen >= SEEN).then(|| middle(cell))).collect();
    let mut pass_on = |cell: usize, beside: [(isize, isize); 4]| {
        let (row, column) = (cell / CELLS, cell % CELLS);
        for (down, right) in beside {
            let (row, column) = (row.wrapping_add_signed(down), column.wrapping_add_signed(right));
            if row < CELLS && column < CELLS {
                let far =
                    |place: Option<Vec2>| place.map_or(f32::INFINITY, |place| place.distance_squared(middle(cell)));
                let other = nearest[row * CELLS + column];
                if far(other) < far(nearest[cell]) {
                    nearest[cell] = other;
                }
            }
        }
    };
    // Twice, so that what lies around a corner arrives, too.
    for _ in 0..2 {
        (0..AREA).for_each(|cell| pass_on(cell, [(0, -1), (-1, -1), (-1, 0), (-1, 1)]));
        (0..AREA).rev().for_each(|cell| pass_on(cell, [(0, 1), (1, 1), (1, 0), (1, -1)]));
    }
    nearest.into_iter().enumerate().map(|(cell, nearest)| nearest.unwrap_or(middle(cell))).collect()
}
