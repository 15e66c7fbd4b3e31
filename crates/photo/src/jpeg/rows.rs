//! Record of the rows that were lost.

use std::ops::Range;

pub(crate) struct Rows {
    lost: Vec<bool>,
    /// Whether the data ends before the last row.
    pub(crate) ends_early: bool,
}

impl Rows {
    pub(crate) fn new(height: usize) -> Self {
        Self { lost: vec![false; height], ends_early: false }
    }

    pub(crate) fn lose(&mut self, rows: Range<usize>) {
        let height = self.lost.len();
        self.lost[rows.start.min(height)..rows.end.min(height)].fill(true);
    }

    pub(crate) fn intact(&self) -> usize {
        self.lost.iter().filter(|lost| !**lost).count()
    }

    /// Replaces lost rows, and rows interpolated from them, with the nearest intact row above; at the top, below.
    pub(crate) fn repair(&self, rgb: &mut [u8], row_bytes: usize, blurred_rows: usize) {
        let height = self.lost.len();
        let near = |row: usize| row.saturating_sub(blurred_rows)..(row + blurred_rows + 1).min(height);
        let is_lost = |row: &usize| self.lost[near(*row)].contains(&true);
        let Some(first) = (0..height).find(|row| !is_lost(row)) else { return };
        let mut source = first;
        for row in 0..height {
            if is_lost(&row) {
                rgb.copy_within(source * row_bytes..(source + 1) * row_bytes, row * row_bytes);
            } else {
                source = row;
            }
        }
    }
}
