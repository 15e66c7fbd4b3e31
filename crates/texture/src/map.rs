//! Small square pictures of smooth things: what is slower than a detail is worked out at this size, whatever the texture's.

use std::ops::{Add, Mul};

use glam::Vec3;

/// Cells along each side; lengths below are in cells.
pub(crate) const CELLS: usize = 256;

/// Number of cells.
pub(crate) const AREA: usize = CELLS * CELLS;

/// What a cell can hold: a number or a colour.
pub(crate) trait Value: Copy + Default + Add<Output = Self> + Mul<f32, Output = Self> {}

impl<T: Copy + Default + Add<Output = T> + Mul<f32, Output = T>> Value for T {}

/// The cubic B-spline's weights.
const TAPS: [f32; 5] = [0.0625, 0.25, 0.375, 0.25, 0.0625];

/// Blurred as often, each time with the taps twice as far apart ("à trous"): the standard deviation is 1, 2.2, 4.6, 9.2 … cells.
/// What is beyond the border counts as nothing. Sums of what is not negative only, so that what is nothing stays so exactly.
pub(crate) fn blurred<T: Value>(map: &[T], times: u32, side: usize) -> Vec<T> {
    let mut blurred = map.to_vec();
    for level in 0..times {
        let once = along_columns(&blurred, 1 << level, side);
        blurred = along_rows(&once, 1 << level, side);
    }
    blurred
}

fn along_columns<T: Value>(map: &[T], step: usize, side: usize) -> Vec<T> {
    let mut sums = vec![T::default(); map.len()];
    for (row, sums) in sums.chunks_mut(side).enumerate() {
        for (tap, weight) in TAPS.into_iter().enumerate() {
            let Some(from) = (row + tap * step).checked_sub(2 * step).filter(|from| *from < side) else { continue };
            add(sums, &map[from * side..(from + 1) * side], weight);
        }
    }
    sums
}

fn along_rows<T: Value>(map: &[T], step: usize, side: usize) -> Vec<T> {
    let mut sums = vec![T::default(); map.len()];
    for (sums, row) in sums.chunks_mut(side).zip(map.chunks(side)) {
        for (tap, weight) in TAPS.into_iter().enumerate() {
            let (before, beyond) = ((2 * step).saturating_sub(tap * step), (tap * step).saturating_sub(2 * step));
            if before < side && beyond < side {
                add(&mut sums[before..], &row[beyond..], weight);
            }
        }
    }
    sums
}

fn add<T: Value>(sums: &mut [T], values: &[T], weight: f32) {
    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum = *sum + *value * weight);
}

/// The mean of what is around each cell, by weights, with how much weight there was.
pub(crate) fn mean_around<T: Value>(map: &[T], weights: &[f32], times: u32) -> (Vec<T>, Vec<f32>) {
    let weighted: Vec<T> = map.iter().zip(weights).map(|(value, weight)| *value * *weight).collect();
    let (sums, weights) = (blurred(&weighted, times, CELLS), blurred(weights, times, CELLS));
    let means = sums.iter().zip(&weights).map(|(sum, weight)| divided(*sum, *weight));
    (means.collect(), weights)
}

/// Nothing where there is no weight.
pub(crate) fn divided<T: Value>(sum: T, weight: f32) -> T {
    if weight > 0.0 { sum * (1.0 / weight) } else { T::default() }
}

/// 0 up to `from`, 1 from `to` on, and smooth between them.
pub(crate) fn ramp(value: f32, from: f32, to: f32) -> f32 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// How far each cell is from the nearest of some, in cells, by steps along rows, columns and diagonals; what is beyond the
/// border is none of them. Exact along these, and 8 % too long between.
pub(crate) fn distances(sources: &[bool]) -> Vec<f32> {
    const FAR: u32 = u32::MAX / 2;
    let mut steps: Vec<u32> = sources.iter().map(|is_source| if *is_source { 0 } else { FAR }).collect();
    // Thirds of a cell: 3 straight on, 4 across.
    let mut reach = |cell: usize, row: usize, ahead: [(isize, isize, u32); 4]| {
        let column = cell % CELLS;
        for (down, right, length) in ahead {
            let (row, column) = (row.wrapping_add_signed(down), column.wrapping_add_signed(right));
            if row < CELLS && column < CELLS {
                steps[cell] = steps[cell].min(steps[row * CELLS + column] + length);
            }
        }
    };
    for cell in 0..AREA {
        reach(cell, cell / CELLS, [(0, -1, 3), (-1, -1, 4), (-1, 0, 3), (-1, 1, 4)]);
    }
    for cell in (0..AREA).rev() {
        reach(cell, cell / CELLS, [(0, 1, 3), (1, 1, 4), (1, 0, 3), (1, -1, 4)]);
    }
    steps.into_iter().map(|steps| steps as f32 / 3.0).collect()
}

/// Half up, and what is beyond 0 and 255 ends there.
pub(crate) fn bytes(levels: Vec3) -> [u8; 3] {
    levels.to_array().map(|level| (level + 0.5) as u8)
}
