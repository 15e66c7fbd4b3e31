use glam::DVec3;

use crate::folds::doubled_area;

/// Cells of the depth picture along the longer side of what is looked at.
const CELLS: f64 = 192.0;
/// A vertex faces the viewer if its triangles show the front with more than this share of what they show at all.
const FRONT_SHARE: f64 = 0.4;

/// Which vertices of a surface are seen: they face the viewer, and nothing of it lies before them by more than `behind`.
///
/// `places` are px of the picture, y down, and the way towards the viewer in any unit, which is that of `behind`. Triangles
/// wind counter-clockwise as they are seen from the front.
pub fn seen(triangles: &[[u32; 3]], places: &[DVec3], behind: f64) -> Vec<bool> {
    let fronts = fronts(triangles, places);
    let Some(depths) = Depths::of(triangles, places) else { return vec![false; places.len()] };
    let is_seen =
        |(&place, front): (&DVec3, f64)| front > FRONT_SHARE && place.is_finite() && depths.before(place) <= behind;
    places.iter().zip(fronts).map(is_seen).collect()
}

/// For each vertex, how much of what its triangles show is the front: −1 to 1.
fn fronts(triangles: &[[u32; 3]], places: &[DVec3]) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); places.len()];
    for corners in triangles {
        // y is down: what winds counter-clockwise for the eye has a negative area.
        let front = -doubled_area(corners.map(|corner| places[corner as usize].truncate()));
        for &corner in corners {
            let (fronts, all) = &mut sums[corner as usize];
            *fronts += front;
            *all += front.abs();
        }
    }
    sums.into_iter().map(|(fronts, all): (f64, f64)| if all > 0.0 { fronts / all } else { 0.0 }).collect()
}

/// How near the surface comes in each cell of a coarse picture.
struct Depths {
    low: DVec3,
    per_px: f64,
    columns: usize,
    nearest: Vec<f64>,
}

impl Depths {
    /// Of the places that are some; none if they do not extend.
    fn of(triangles: &[[u32; 3]], places: &[DVec3]) -> Option<Self> {
        let mut finite = places.iter().filter(|place| place.is_finite());
        let first = *finite.next()?;
        let (low, high) = finite.fold((first, first), |(low, high), place| (low.min(*place), high.max(*place)));
        let size = (high - low).truncate();
        if !(size.max_element() > 0.0 && size.is_finite()) {
            return None;
        }
        let per_px = CELLS / size.max_element();
        let [columns, rows] = [size.x, size.y].map(|side| (side * per_px) as usize + 1);
        let mut depths = Self { low, per_px, columns, nearest: vec![f64::NEG_INFINITY; columns * rows] };
        let is_somewhere = |corners: &&[u32; 3]| corners.iter().all(|&corner| places[corner as usize].is_finite());
        for corners in triangles.iter().filter(is_somewhere) {
            depths.draw(corners.map(|corner| depths.cell(places[corner as usize])));
        }
        Some(depths)
    }

    /// How far a place is behind the nearest there.
    fn before(&self, place: DVec3) -> f64 {
        let cell = self.cell(place);
        self.nearest[cell.y as usize * self.columns + cell.x as usize] - place.z
    }

    fn cell(&self, place: DVec3) -> DVec3 {
        ((place - self.low).truncate() * self.per_px).extend(place.z)
    }

    /// The cells whose middles a triangle covers.
    fn draw(&mut self, [a, b, c]: [DVec3; 3]) {
        let area = doubled_area([a, b, c].map(DVec3::truncate));
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        if area == 0.0 {
            return;
        }
        for row in low.y as usize..=high.y as usize {
            for column in low.x as usize..=high.x as usize {
                let middle = glam::DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let share = |from: DVec3, to: DVec3| doubled_area([from.truncate(), to.truncate(), middle]) / area;
                let [of_a, of_b, of_c] = [share(b, c), share(c, a), share(a, b)];
                if of_a >= 0.0 && of_b >= 0.0 && of_c >= 0.0 {
                    let nearest = &mut self.nearest[row * self.columns + column];
                    *nearest = nearest.max(of_a * a.z + of_b * b.z + of_c * c.z);
                }
            }
        }
    }
}
