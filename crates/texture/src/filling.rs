//! Pull-push interpolation (Gortler et al., "The Lumigraph", SIGGRAPH 1996): fills unknown values from known ones, over
//! a pyramid of coarser maps.

use crate::map::{CELLS, Value, blurred, divided};

/// Number of smoothing passes over filled values.
const PASSES: usize = 3;
/// Levels of [`blurred`] in a pass.
const BLUR: u32 = 3;

/// Fills values where `known` is 0, keeps them where it is 1, and mixes in between.
///
/// Linear in the values, with weights that sum to 1 in each cell, so constants are preserved.
pub(crate) fn filled<T: Value>(values: &[T], known: &[f32]) -> Vec<T> {
    let mut filled = pull_push(values, known, CELLS);
    let ones = blurred(&vec![1.0; filled.len()], BLUR, CELLS);
    for _ in 0..PASSES {
        let smooth = blurred(&filled, BLUR, CELLS);
        for (cell, value) in filled.iter_mut().enumerate() {
            *value = values[cell] * known[cell] + divided(smooth[cell], ones[cell]) * (1.0 - known[cell]);
        }
    }
    filled
}

fn pull_push<T: Value>(values: &[T], known: &[f32], side: usize) -> Vec<T> {
    if side == 1 {
        return values.to_vec();
    }
    let half = side / 2;
    let (mut coarse, mut coarse_known) = (Vec::with_capacity(half * half), Vec::with_capacity(half * half));
    for cell in 0..half * half {
        let first = cell / half * 2 * side + cell % half * 2;
        let four = [first, first + 1, first + side, first + side + 1];
        let sum = four.iter().fold(T::default(), |sum, &cell| sum + values[cell] * known[cell]);
        let weight: f32 = four.iter().map(|&cell| known[cell]).sum();
        coarse.push(divided(sum, weight));
        coarse_known.push(weight.min(1.0));
    }
    let coarse = pull_push(&coarse, &coarse_known, half);
    let mut filled = values.to_vec();
    for (cell, value) in filled.iter_mut().enumerate() {
        *value = *value * known[cell] + upsampled(&coarse, half, cell % side, cell / side) * (1.0 - known[cell]);
    }
    filled
}

/// A map of half the side, interpolated bilinearly at the centre of a fine cell.
fn upsampled<T: Value>(coarse: &[T], half: usize, column: usize, row: usize) -> T {
    let neighbours = |fine: usize| {
        let other = if fine.is_multiple_of(2) { (fine / 2).saturating_sub(1) } else { (fine / 2 + 1).min(half - 1) };
        (fine / 2, other)
    };
    let ((x, far_x), (y, far_y)) = (neighbours(column), neighbours(row));
    let at = |x: usize, y: usize| coarse[y * half + x];
    at(x, y) * 0.5625 + (at(far_x, y) + at(x, far_y)) * 0.1875 + at(far_x, far_y) * 0.0625
}
