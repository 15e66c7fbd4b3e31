use glam::DVec2;

use crate::cells::Cells;
use crate::folds::{FoldRemoval, doubled_area};
use crate::layout::{Layout, Role, bounds, delaunay};

/// Coarse triangulation of a subset of the points. Large folds unfold in a few iterations on it; on the fine one they
/// open only one small triangle at a time.
pub(crate) struct Coarse {
    /// Indices of points of the fine triangulation.
    points: Vec<u32>,
    fold_removal: FoldRemoval,
    /// The remaining points, located in the coarse triangulation.
    embedded: Vec<Embedded>,
    targets: Vec<DVec2>,
    offsets: Vec<DVec2>,
}

/// A point of the fine triangulation inside a triangle of the coarse one.
struct Embedded {
    point: u32,
    corners: [u32; 3],
    weights: [f64; 3],
}

/// Minimum distance of moved points, in lattice spacings.
const MIN_DISTANCE: f64 = 0.5;

impl Coarse {
    pub(crate) fn new(fine: &Layout) -> Self {
        let points = thinned(fine);
        let positions: Vec<DVec2> = points.iter().map(|&point| fine.points[point as usize]).collect();
        let roles: Vec<Role> = points.iter().map(|&point| fine.roles[point as usize]).collect();
        let triangles = delaunay(&positions);
        let embedded = located(fine, &points, &triangles, &positions);
        let fold_removal = FoldRemoval::new(&triangles, &positions, &roles);
        let [targets, offsets] = [(); 2].map(|()| vec![DVec2::ZERO; points.len()]);
        Self { points, fold_removal, embedded, targets, offsets }
    }

    /// Unfolds the coarse triangulation. Fine points in a changed triangle take the interpolated offset of its corners.
    pub(crate) fn unfold(&mut self, fine: &mut [DVec2]) {
        self.targets.iter_mut().zip(&self.points).for_each(|(targets, &point)| *targets = fine[point as usize]);
        self.offsets.copy_from_slice(&self.targets);
        self.fold_removal.limit(&mut self.offsets);
        let is_changed = |corner: &u32| self.offsets[*corner as usize] != self.targets[*corner as usize];
        for Embedded { point, corners, weights } in self.embedded.iter().filter(|at| at.corners.iter().any(is_changed))
        {
            let weighted = corners.iter().zip(weights).map(|(&corner, share)| *share * self.offsets[corner as usize]);
            fine[*point as usize] = weighted.sum();
        }
        self.offsets.iter().zip(&self.points).for_each(|(offset, &point)| fine[point as usize] = *offset);
    }
}

/// Moved points at a minimum distance from each other, and all other points.
fn thinned(fine: &Layout) -> Vec<u32> {
    let min_distance = MIN_DISTANCE * fine.spacing;
    let mut cells = Cells::over(bounds(&fine.points), fine.spacing);
    let mut is_apart = |position: DVec2| {
        let is_apart = cells.distance(position, min_distance) == f64::INFINITY;
        if is_apart {
            cells.add(position, ());
        }
        is_apart
    };
    let selected = fine.points.iter().zip(&fine.roles).zip(0..).filter(|((position, role), _)| match role {
        Role::Moved { .. } => is_apart(**position),
        Role::Fixed | Role::Free => true,
    });
    selected.map(|(_, point)| point).collect()
}

/// Triangles and barycentric coordinates of the points that were not selected.
fn located(fine: &Layout, selected: &[u32], triangles: &[[u32; 3]], positions: &[DVec2]) -> Vec<Embedded> {
    let mut is_selected = vec![false; fine.points.len()];
    selected.iter().for_each(|&point| is_selected[point as usize] = true);
    let mut remaining = Cells::over(bounds(&fine.points), fine.spacing);
    for (point, &position) in (0..).zip(&fine.points).filter(|(point, _)| !is_selected[*point as usize]) {
        remaining.add(position, point);
    }
    let mut located: Vec<Option<Embedded>> = (0..fine.points.len()).map(|_| None).collect();
    for &corners in triangles {
        let triangle = corners.map(|corner| positions[corner as usize]);
        for (position, point) in remaining.in_box(bounds(&triangle)) {
            let found = Embedded { point, corners, weights: weights(position, triangle) };
            let known = &mut located[point as usize];
            // Rounding can place a point on an edge in both triangles or in none; take the best.
            if known.as_ref().is_none_or(|known| known.least() < found.least()) {
                *known = Some(found);
            }
        }
    }
    located.into_iter().flatten().collect()
}

impl Embedded {
    fn least(&self) -> f64 {
        self.weights.into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// Barycentric coordinates.
fn weights(position: DVec2, [a, b, c]: [DVec2; 3]) -> [f64; 3] {
    [[position, b, c], [a, position, c], [a, b, position]].map(|part| doubled_area(part) / doubled_area([a, b, c]))
}
