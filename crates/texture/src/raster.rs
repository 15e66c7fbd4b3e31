use std::ops::Range;

use glam::{DVec2, DVec3};

/// Pixels of one row whose centres lie in a triangle.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Row, from the top.
    pub row: usize,
    /// Columns, from the left.
    pub columns: Range<usize>,
    /// Barycentric coordinates at the centre of the first pixel; they sum to 1.
    pub shares: DVec3,
    /// Change of the barycentric coordinates from one column to the next.
    pub step: DVec3,
}

impl Span {
    /// Columns with the barycentric coordinates at their pixels' centres.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, DVec3)> {
        let Self { columns, shares, step, .. } = self.clone();
        columns.enumerate().map(move |(along, column)| (column, shares + step * along as f64))
    }
}

/// Rasterises a triangle: one span per covered row of a picture of `size_px` (columns, rows), from the top.
///
/// `corners_px` are in px from the picture's top left corner, y down, in either orientation. A pixel belongs to the
/// triangle that contains its centre; a centre on an edge belongs to the triangle to its right or below it. Triangles
/// without area or with a non-finite corner cover nothing.
pub fn spans(corners_px: [DVec2; 3], size_px: [usize; 2]) -> impl Iterator<Item = Span> {
    let [a, b, c] = corners_px;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let doubled_area = (b - a).perp_dot(c - a);
    let is_valid = doubled_area != 0.0 && corners_px.iter().all(|corner| corner.is_finite());
    let rows = if is_valid { centres(low.y, high.y, size_px[1]) } else { 0..0 };
    let slope = |from: DVec2, to: DVec2| -(to.y - from.y) / doubled_area;
    let step = DVec3::new(slope(b, c), slope(c, a), slope(a, b));
    rows.filter_map(move |row| {
        let y = row as f64 + 0.5;
        let (left, right) = intersection(corners_px, y)?;
        let columns = centres(left, right, size_px[0]);
        let at = DVec2::new(columns.start as f64 + 0.5, y);
        let share = |from: DVec2, to: DVec2| (to - from).perp_dot(at - from) / doubled_area;
        let (of_a, of_b) = (share(b, c), share(c, a));
        (!columns.is_empty()).then(|| Span { row, columns, shares: DVec3::new(of_a, of_b, 1.0 - of_a - of_b), step })
    })
}

/// Indices of the pixels whose centres lie in a half-open interval.
fn centres(low: f64, high: f64, count: usize) -> Range<usize> {
    let first = (low - 0.5).ceil().max(0.0);
    let beyond = (high - 0.5).ceil().min(count as f64);
    first as usize..beyond.max(first) as usize
}

/// Intersection of a horizontal line with a triangle.
fn intersection([a, b, c]: [DVec2; 3], y: f64) -> Option<(f64, f64)> {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        // Top to bottom, so that the triangles on both sides of an edge compute the same intersection and leave no gap.
        let (from, to) = if (from.y, from.x) < (to.y, to.x) { (from, to) } else { (to, from) };
        if from.y <= y && y < to.y {
            let x = from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y);
            ends = (ends.0.min(x), ends.1.max(x));
        }
    }
    (ends.0 < ends.1).then_some(ends)
}
