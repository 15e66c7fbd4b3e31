//! Pull-push (Gortler et al., "The Lumigraph", SIGGRAPH 1996): what is unknown is filled from what is known around it, over
//! ever coarser maps and back.

use crate::map::{CELLS, Value, blurred, divided};

/// How often what was filled is smoothed.
const SMOOTHINGS: usize = 3;
/// By which blur: [`blurred`]'s times.
const SMOOTHED_BY: u32 = 3;

/// The values where they are known (1), what is around them where they are not (0), and something of both between.
///
/// Linear in the values, and of equal values makes nothing else: of each cell the weights sum to 1.
pub(crate) fn filled<T: Value>(values: &[T], known: &[f32]) -> Vec<T> {
    let mut filled = pushed(values, known, CELLS);
    let ones = blurred(&vec![1.0; filled.len()], SMOOTHED_BY, CELLS);
    for _ in 0..SMOOTHINGS {
        let smooth = blurred(&filled, SMOOTHED_BY, CELLS);
        for (cell, value) in filled.iter_mut().enumerate() {
            *value = values[cell] * known[cell] + divided(smooth[cell], ones[cell]) * (1.0 - known[cell]);
        }
    }
    filled
}

fn pushed<T: Value>(values: &[T], known: &[f32], side: usize) -> Vec<T> {
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
    let coarse = pushed(&coarse, &coarse_known, half);
    let mut pushed = values.to_vec();
    for (cell, value) in pushed.iter_mut().enumerate() {
        *value = *value * known[cell] + between(&coarse, half, cell % side, cell / side) * (1.0 - known[cell]);
    }
    pushed
}

/// What a map of half the side has in the middle of a cell: nine, three and three sixteenths and one of the four around it.
fn between<T: Value>(coarse: &[T], half: usize, column: usize, row: usize) -> T {
    let beside = |fine: usize| {
        let other = if fine.is_multiple_of(2) { (fine / 2).saturating_sub(1) } else { (fine / 2 + 1).min(half - 1) };
        (fine / 2, other)
    };
    let ((x, far_x), (y, far_y)) = (beside(column), beside(row));
    let at = |x: usize, y: usize| coarse[y * half + x];
    at(x, y) * 0.5625 + (at(far_x, y) + at(x, far_y)) * 0.1875 + at(far_x, far_y) * 0.0625
}
