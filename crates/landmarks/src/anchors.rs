/// Number of anchor boxes of the detector.
pub(crate) const ANCHOR_COUNT: usize = 896;

/// Centres (x, y) of the detector's anchors, normalised to its input: a 16 × 16 grid with 2 anchors per cell, then an 8
/// × 8 grid with 6. Row by row, with the anchors of a cell together.
pub(crate) fn anchors() -> Vec<[f32; 2]> {
    [(16, 2), (8, 6)].into_iter().flat_map(|(cells, copies)| grid(cells, copies)).collect()
}

fn grid(cells: usize, copies: usize) -> impl Iterator<Item = [f32; 2]> {
    let centre = move |cell: usize| (cell as f32 + 0.5) / cells as f32;
    (0..cells * cells).flat_map(move |i| std::iter::repeat_n([centre(i % cells), centre(i / cells)], copies))
}
