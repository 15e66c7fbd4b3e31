use glam::DVec2;

use crate::cells::Cells;
use crate::folds::{Unfolding, doubled_area};
use crate::layout::{Layout, Tie, bounds, delaunay};

/// A triangulation of fewer points of another, which is unfolded in few steps: in a fine one what folds widely is pushed open
/// by one small triangle after the other.
pub(crate) struct Coarse {
    /// Points of the fine triangulation.
    points: Vec<u32>,
    unfolding: Unfolding,
    /// The others, and where they are in the coarse one.
    between: Vec<Between>,
    wanted: Vec<DVec2>,
    offsets: Vec<DVec2>,
}

/// A point of the fine triangulation within a triangle of the coarse one.
struct Between {
    point: u32,
    corners: [u32; 3],
    shares: [f64; 3],
}

/// Points that lead are so many of the lattice's spacings apart at least.
const APART: f64 = 0.5;

impl Coarse {
    pub(crate) fn new(fine: &Layout) -> Self {
        let points = thinned(fine);
        let places: Vec<DVec2> = points.iter().map(|&point| fine.points[point as usize]).collect();
        let ties: Vec<Tie> = points.iter().map(|&point| fine.ties[point as usize]).collect();
        let triangles = delaunay(&places);
        let between = located(fine, &points, &triangles, &places);
        let unfolding = Unfolding::new(&triangles, &places, &ties);
        let [wanted, offsets] = [(); 2].map(|()| vec![DVec2::ZERO; points.len()]);
        Self { points, unfolding, between, wanted, offsets }
    }

    /// Unfolds the coarse triangulation, and changes the offsets of the fine one with it: what lies in a triangle that had to be
    /// changed goes along with its corners.
    pub(crate) fn unfold(&mut self, fine: &mut [DVec2]) {
        self.wanted.iter_mut().zip(&self.points).for_each(|(wanted, &point)| *wanted = fine[point as usize]);
        self.offsets.copy_from_slice(&self.wanted);
        self.unfolding.limit(&mut self.offsets);
        let is_changed = |corner: &u32| self.offsets[*corner as usize] != self.wanted[*corner as usize];
        for Between { point, corners, shares } in self.between.iter().filter(|at| at.corners.iter().any(is_changed)) {
            let ways = corners.iter().zip(shares).map(|(&corner, share)| *share * self.offsets[corner as usize]);
            fine[*point as usize] = ways.sum();
        }
        self.offsets.iter().zip(&self.points).for_each(|(offset, &point)| fine[point as usize] = *offset);
    }
}

/// Of the points that lead, those that are apart from the ones before; all others.
fn thinned(fine: &Layout) -> Vec<u32> {
    let apart = APART * fine.spacing;
    let mut cells = Cells::over(bounds(&fine.points), fine.spacing);
    let mut is_apart = |place: DVec2| {
        let is_apart = cells.distance(place, apart) == f64::INFINITY;
        if is_apart {
            cells.add(place, ());
        }
        is_apart
    };
    let kept = fine.points.iter().zip(&fine.ties).zip(0..).filter(|((place, tie), _)| match tie {
        Tie::Follows { .. } => is_apart(**place),
        Tie::Stays | Tie::Free => true,
    });
    kept.map(|(_, point)| point).collect()
}

/// In which triangle of those that were kept each of the others lies.
fn located(fine: &Layout, kept: &[u32], triangles: &[[u32; 3]], places: &[DVec2]) -> Vec<Between> {
    let mut is_kept = vec![false; fine.points.len()];
    kept.iter().for_each(|&point| is_kept[point as usize] = true);
    let mut left_out = Cells::over(bounds(&fine.points), fine.spacing);
    for (point, &place) in (0..).zip(&fine.points).filter(|(point, _)| !is_kept[*point as usize]) {
        left_out.add(place, point);
    }
    let mut located: Vec<Option<Between>> = (0..fine.points.len()).map(|_| None).collect();
    for &corners in triangles {
        let triangle = corners.map(|corner| places[corner as usize]);
        for (place, point) in left_out.in_box(bounds(&triangle)) {
            let found = Between { point, corners, shares: shares(place, triangle) };
            let known = &mut located[point as usize];
            // On an edge both triangles say so, each as exactly as it can.
            if known.as_ref().is_none_or(|known| known.least() < found.least()) {
                *known = Some(found);
            }
        }
    }
    located.into_iter().flatten().collect()
}

impl Between {
    fn least(&self) -> f64 {
        self.shares.into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// How much of each corner is in a place.
fn shares(place: DVec2, [a, b, c]: [DVec2; 3]) -> [f64; 3] {
    [[place, b, c], [a, place, c], [a, b, place]].map(|part| doubled_area(part) / doubled_area([a, b, c]))
}
