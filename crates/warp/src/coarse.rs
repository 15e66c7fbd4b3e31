use std::collections::HashMap;

use glam::{DVec2, IVec2};

use crate::folds::{Unfolding, doubled_area};
use crate::layout::{Layout, Tie, delaunay};

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
        let between = between(fine, &points, &triangles, &places);
        let unfolding = Unfolding::new(&triangles, &places, &ties);
        let [wanted, offsets] = [(); 2].map(|()| vec![DVec2::ZERO; points.len()]);
        Self { points, unfolding, between, wanted, offsets }
    }

    /// Changes offsets of the fine triangulation until the coarse one is not folded. What lies within its triangles goes with
    /// their corners where those are not to go where they were.
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

/// Of the points that lead those that are apart; all others.
fn thinned(fine: &Layout) -> Vec<u32> {
    let apart = APART * fine.spacing;
    let mut cells: HashMap<IVec2, Vec<DVec2>> = HashMap::new();
    let mut is_apart = |place: DVec2| {
        let cell = (place / apart).floor().as_ivec2();
        let around = (-1..=1).flat_map(|y| (-1..=1).map(move |x| cell + IVec2::new(x, y)));
        let is_free = around.filter_map(|cell| cells.get(&cell)).flatten().all(|other| other.distance(place) >= apart);
        cells.entry(cell).or_default().extend(is_free.then_some(place));
        is_free
    };
    let kept = fine.points.iter().zip(&fine.ties).zip(0..).filter(|((place, tie), _)| match tie {
        Tie::Follows { .. } => is_apart(**place),
        Tie::Stays | Tie::Free => true,
    });
    kept.map(|(_, point)| point).collect()
}

/// Where the points that were left out are.
fn between(fine: &Layout, kept: &[u32], triangles: &[[u32; 3]], places: &[DVec2]) -> Vec<Between> {
    let cell = |place: DVec2| (place / fine.spacing).floor().as_ivec2();
    let corners_of = |corners: &[u32; 3]| corners.map(|corner| places[corner as usize]);
    let mut cells: HashMap<IVec2, Vec<[u32; 3]>> = HashMap::new();
    for corners in triangles {
        let [a, b, c] = corners_of(corners);
        let (low, high) = (cell(a.min(b).min(c)), cell(a.max(b).max(c)));
        for at in (low.y..=high.y).flat_map(|y| (low.x..=high.x).map(move |x| IVec2::new(x, y))) {
            cells.entry(at).or_default().push(*corners);
        }
    }
    let mut is_kept = vec![false; fine.points.len()];
    kept.iter().for_each(|&point| is_kept[point as usize] = true);
    let left_out = (0..fine.points.len() as u32).filter(|&point| !is_kept[point as usize]);
    let located = left_out.filter_map(|point| {
        let place = fine.points[point as usize];
        let candidates = cells.get(&cell(place))?.iter().map(|corners| (*corners, shares(place, corners_of(corners))));
        let least = |shares: &[f64; 3]| shares.iter().copied().fold(f64::INFINITY, f64::min);
        // On an edge both triangles say so, each as exactly as it can.
        let (corners, shares) = candidates.max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b)))?;
        Some(Between { point, corners, shares })
    });
    located.collect()
}

/// Of each corner in a place.
fn shares(place: DVec2, [a, b, c]: [DVec2; 3]) -> [f64; 3] {
    [[place, b, c], [a, place, c], [a, b, place]].map(|part| doubled_area(part) / doubled_area([a, b, c]))
}
