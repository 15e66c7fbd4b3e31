use std::ops::Range;

use glam::{DVec2, DVec3};

/// The pixels of one row whose middles lie in a triangle.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// The row, 0 at the top.
    pub row: usize,
    /// The columns, 0 at the left.
    pub columns: Range<usize>,
    /// Shares of the triangle's corners in the middle of the first pixel; they sum to 1.
    pub shares: DVec3,
    /// What is added to the shares from a column to the next.
    pub step: DVec3,
}

impl Span {
    /// Each pixel's column with the shares of the corners in its middle.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, DVec3)> {
        let Self { columns, shares, step, .. } = self.clone();
        columns.enumerate().map(move |(along, column)| (column, shares + step * along as f64))
    }
}

/// Draws a triangle: the rows of pixels that it covers in a picture of `size_px` (columns, rows), from the top.
///
/// `corners_px` are px from the picture's top left corner, y down, in either sense of rotation. A pixel belongs to a triangle
/// if its middle does; of the two triangles at an edge exactly one has a middle that lies on it, the one to the right or
/// below. Triangles without area, or with a corner that is not finite, cover nothing.
pub fn spans(corners_px: [DVec2; 3], size_px: [usize; 2]) -> impl Iterator<Item = Span> {
    let [a, b, c] = corners_px;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let doubled_area = (b - a).perp_dot(c - a);
    let is_some = doubled_area != 0.0 && corners_px.iter().all(|corner| corner.is_finite());
    let rows = if is_some { middles(low.y, high.y, size_px[1]) } else { 0..0 };
    let slope = |from: DVec2, to: DVec2| -(to.y - from.y) / doubled_area;
    let step = DVec3::new(slope(b, c), slope(c, a), slope(a, b));
    rows.filter_map(move |row| {
        let y = row as f64 + 0.5;
        let (left, right) = crossed(corners_px, y)?;
        let columns = middles(left, right, size_px[0]);
        let at = DVec2::new(columns.start as f64 + 0.5, y);
        let share = |from: DVec2, to: DVec2| (to - from).perp_dot(at - from) / doubled_area;
        let (of_a, of_b) = (share(b, c), share(c, a));
        (!columns.is_empty()).then(|| Span { row, columns, shares: DVec3::new(of_a, of_b, 1.0 - of_a - of_b), step })
    })
}

/// The pixels of a row or column whose middles lie between two places, the first one included.
fn middles(low: f64, high: f64, count: usize) -> Range<usize> {
    let first = (low - 0.5).ceil().max(0.0);
    let beyond = (high - 0.5).ceil().min(count as f64);
    first as usize..beyond.max(first) as usize
}

/// From where to where a horizontal line lies in a triangle.
fn crossed([a, b, c]: [DVec2; 3], y: f64) -> Option<(f64, f64)> {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        // From the top, so that both triangles at an edge cross it at the same place, to the last bit: no pixel is between.
        let (from, to) = if (from.y, from.x) < (to.y, to.x) { (from, to) } else { (to, from) };
        if from.y <= y && y < to.y {
            let x = from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y);
            ends = (ends.0.min(x), ends.1.max(x));
        }
    }
    (ends.0 < ends.1).then_some(ends)
}
