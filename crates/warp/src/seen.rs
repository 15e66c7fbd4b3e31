use glam::DVec3;

use crate::folds::doubled_area;

/// Cells of the depth buffer along the longer side.
const CELLS: f64 = 192.0;
/// Minimum share of front-facing area around a visible vertex.
const FRONT_SHARE: f64 = 0.4;

/// Visible vertices of a surface: they face the viewer and lie at most `behind` behind the nearest surface.
///
/// `positions` are x and y in px of the picture, y down, and the depth towards the viewer in the unit of `behind`.
/// Triangles are counter-clockwise seen from the front.
pub fn seen(triangles: &[[u32; 3]], positions: &[DVec3], behind: f64) -> Vec<bool> {
    let fronts = fronts(triangles, positions);
    let Some(depths) = Depths::of(triangles, positions) else { return vec![false; positions.len()] };
    let is_seen = |(&position, front): (&DVec3, f64)| {
        front > FRONT_SHARE && position.is_finite() && depths.depth_below(position) <= behind
    };
    positions.iter().zip(fronts).map(is_seen).collect()
}

/// Front-facing minus back-facing share of the projected area around each vertex, −1 to 1.
fn fronts(triangles: &[[u32; 3]], positions: &[DVec3]) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); positions.len()];
    for corners in triangles {
        // y points down, so counter-clockwise triangles have a negative area.
        let front = -doubled_area(corners.map(|corner| positions[corner as usize].truncate()));
        for &corner in corners {
            let (fronts, all) = &mut sums[corner as usize];
            *fronts += front;
            *all += front.abs();
        }
    }
    sums.into_iter().map(|(fronts, all): (f64, f64)| if all > 0.0 { fronts / all } else { 0.0 }).collect()
}

/// Depth buffer at a coarse resolution.
struct Depths {
    low: DVec3,
    per_px: f64,
    columns: usize,
    nearest: Vec<f64>,
}

impl Depths {
    /// Depth buffer of the finite positions; `None` if they have no extent.
    fn of(triangles: &[[u32; 3]], positions: &[DVec3]) -> Option<Self> {
        let mut finite = positions.iter().filter(|position| position.is_finite());
        let first = *finite.next()?;
        let (low, high) =
            finite.fold((first, first), |(low, high), position| (low.min(*position), high.max(*position)));
        let size = (high - low).truncate();
        if !(size.max_element() > 0.0 && size.is_finite()) {
            return None;
        }
        let per_px = CELLS / size.max_element();
        let [columns, rows] = [size.x, size.y].map(|side| (side * per_px) as usize + 1);
        let mut depths = Self { low, per_px, columns, nearest: vec![f64::NEG_INFINITY; columns * rows] };
        let is_finite = |corners: &&[u32; 3]| corners.iter().all(|&corner| positions[corner as usize].is_finite());
        for corners in triangles.iter().filter(is_finite) {
            depths.draw(corners.map(|corner| depths.cell(positions[corner as usize])));
        }
        Some(depths)
    }

    /// Depth of a position below the nearest surface.
    fn depth_below(&self, position: DVec3) -> f64 {
        let cell = self.cell(position);
        self.nearest[cell.y as usize * self.columns + cell.x as usize] - position.z
    }

    fn cell(&self, position: DVec3) -> DVec3 {
        ((position - self.low).truncate() * self.per_px).extend(position.z)
    }

    /// Draws a triangle into the cells whose centres it covers.
    fn draw(&mut self, [a, b, c]: [DVec3; 3]) {
        let area = doubled_area([a, b, c].map(DVec3::truncate));
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        if area == 0.0 {
            return;
        }
        for row in low.y as usize..=high.y as usize {
            for column in low.x as usize..=high.x as usize {
                let centre = glam::DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let share = |from: DVec3, to: DVec3| doubled_area([from.truncate(), to.truncate(), centre]) / area;
                let [of_a, of_b, of_c] = [share(b, c), share(c, a), share(a, b)];
                if of_a >= 0.0 && of_b >= 0.0 && of_c >= 0.0 {
                    let nearest = &mut self.nearest[row * self.columns + column];
                    *nearest = nearest.max(of_a * a.z + of_b * b.z + of_c * c.z);
                }
            }
        }
    }
}
