//! Small square maps of smooth quantities, of a fixed size for all textures.

use std::ops::{Add, Mul};

use glam::Vec3;

/// Cells along each side; other lengths in this crate's maps are in cells.
pub(crate) const CELLS: usize = 256;

/// Number of cells.
pub(crate) const AREA: usize = CELLS * CELLS;

/// Value of a cell: a number or a colour.
pub(crate) trait Value: Copy + Default + Add<Output = Self> + Mul<f32, Output = Self> {}

impl<T: Copy + Default + Add<Output = T> + Mul<f32, Output = T>> Value for T {}

/// Weights of the cubic B-spline.
const TAPS: [f32; 5] = [0.0625, 0.25, 0.375, 0.25, 0.0625];

/// Blurs `levels` times, doubling the distance of the taps each time ("à trous"): standard deviations of 1, 2.2, 4.6,
/// 9.2 … cells. Values beyond the border count as zero. Weights are non-negative, so zeros stay exact.
pub(crate) fn blurred<T: Value>(map: &[T], levels: u32, side: usize) -> Vec<T> {
    let mut blurred = map.to_vec();
    for level in 0..levels {
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

/// Weighted local mean around each cell, and the sum of the weights.
pub(crate) fn mean_around<T: Value>(map: &[T], weights: &[f32], levels: u32) -> (Vec<T>, Vec<f32>) {
    let weighted: Vec<T> = map.iter().zip(weights).map(|(value, weight)| *value * *weight).collect();
    let (sums, weights) = (blurred(&weighted, levels, CELLS), blurred(weights, levels, CELLS));
    let means = sums.iter().zip(&weights).map(|(sum, weight)| divided(*sum, *weight));
    (means.collect(), weights)
}

/// The quotient, or zero for zero weight.
pub(crate) fn divided<T: Value>(sum: T, weight: f32) -> T {
    if weight > 0.0 { sum * (1.0 / weight) } else { T::default() }
}

/// Smoothstep: 0 up to `from`, 1 from `to` on.
pub(crate) fn ramp(value: f32, from: f32, to: f32) -> f32 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Chamfer distance from each cell to the nearest source, in cells. Exact along rows, columns and diagonals, up to 8 %
/// too long in between.
pub(crate) fn distances(sources: &[bool]) -> Vec<f32> {
    const FAR: u32 = u32::MAX / 2;
    let mut steps: Vec<u32> = sources.iter().map(|is_source| if *is_source { 0 } else { FAR }).collect();
    // In thirds of a cell: 3 for a straight step, 4 for a diagonal one.
    let mut relax = |cell: usize, row: usize, ahead: [(isize, isize, u32); 4]| {
        let column = cell % CELLS;
        for (down, right, length) in ahead {
            let (row, column) = (row.wrapping_add_signed(down), column.wrapping_add_signed(right));
            if row < CELLS && column < CELLS {
                steps[cell] = steps[cell].min(steps[row * CELLS + column] + length);
            }
        }
    };
    for cell in 0..AREA {
        relax(cell, cell / CELLS, [(0, -1, 3), (-1, -1, 4), (-1, 0, 3), (-1, 1, 4)]);
    }
    for cell in (0..AREA).rev() {
        relax(cell, cell / CELLS, [(0, 1, 3), (1, 1, 4), (1, 0, 3), (1, -1, 4)]);
    }
    steps.into_iter().map(|steps| steps as f32 / 3.0).collect()
}

/// Rounds half up; the cast saturates.
pub(crate) fn bytes(levels: Vec3) -> [u8; 3] {
    levels.to_array().map(|level| (level + 0.5) as u8)
}
