//! Bilinear sampling of maps at the texture's resolution.

use std::ops::Sub;

use crate::map::{CELLS, Value};

/// Position of a row or column of texels in a map: the cells before and after it, and the fraction between them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) cell: usize,
    next: usize,
    share: f32,
}

impl Sample {
    /// One sample per row or column of a texture.
    pub(crate) fn all(side: usize) -> Vec<Self> {
        (0..side).map(|texel| Self::new(texel, side)).collect()
    }

    fn new(texel: usize, side: usize) -> Self {
        let at = (texel as f32 + 0.5) * (CELLS as f32 / side as f32) - 0.5;
        let at = at.clamp(0.0, (CELLS - 1) as f32);
        let cell = at as usize;
        Self { cell, next: (cell + 1).min(CELLS - 1), share: at - cell as f32 }
    }
}

/// Interpolates a map at a row of texels, for each column of cells.
pub(crate) fn row_of<T: Value + Sub<Output = T>>(map: &[T], row: Sample, into: &mut Vec<T>) {
    let cells = |row: usize| &map[row * CELLS..(row + 1) * CELLS];
    into.clear();
    into.extend(cells(row.cell).iter().zip(cells(row.next)).map(|(above, below)| mixed(*above, *below, row.share)));
}

/// Interpolates such a row at a column of texels.
#[inline]
pub(crate) fn in_row<T: Value + Sub<Output = T>>(row: &[T], column: Sample) -> T {
    mixed(row[column.cell], row[column.next], column.share)
}

/// Interpolates a map bilinearly.
#[inline]
pub(crate) fn bilinear<T: Value + Sub<Output = T>>(map: &[T], column: Sample, row: Sample) -> T {
    let along = |row: usize| in_row(&map[row * CELLS..(row + 1) * CELLS], column);
    mixed(along(row.cell), along(row.next), row.share)
}

#[inline]
fn mixed<T: Value + Sub<Output = T>>(from: T, to: T, share: f32) -> T {
    from + (to - from) * share
}
