//! The surface that a body is made of: checked, its openings closed, and parted where it goes through itself.

use std::collections::HashSet;

use glam::DVec3;
use rosto_mesh::{Surface, Topology};

use crate::crossings::{crossings, crossings_of};
use crate::{SolidError, filling};

/// How often what goes through itself is smoothed before it is given up.
const MOST_ROUNDS: usize = 120;

/// After so many rounds, what is around it is smoothed with it, one ring more each time.
const ROUNDS_A_RING: usize = 6;

/// Where nothing crosses any more, smoothing goes on for one sweep for so many vertices, within bounds: on a denser mesh each
/// goes less far.
const VERTICES_A_SWEEP: usize = 100;

/// A disc: one rim, no vertex unused, nothing that goes through itself.
pub(crate) struct Front {
    pub topology: Topology,
    pub positions: Vec<DVec3>,
    /// The rim, the surface on its left.
    pub rim: Vec<u32>,
    /// The mean length of its sides.
    pub side: f64,
    /// How far smoothing has moved a vertex, at most.
    pub moved: f64,
}

impl Front {
    pub(crate) fn new(surface: Surface<'_>) -> Result<Self, SolidError> {
        let positions = surface.positions().to_vec();
        if let Some(vertex) = positions.iter().position(|place| !place.is_finite()) {
            return Err(SolidError::NotFinite { vertex });
        }
        let mut rims = checked_rims(surface.topology())?;
        let rim = rims.remove(0);
        let mut triangles = surface.topology().triangles().to_vec();
        for mut opening in rims {
            // What fills it lies on the other side of its sides.
            opening.reverse();
            let places: Vec<DVec3> = opening.iter().map(|&vertex| positions[vertex as usize]).collect();
            triangles.extend(filling::least_area(&places).iter().map(|corners| corners.map(|at| opening[at])));
        }
        let topology = Topology::new(positions.len(), triangles)?;
        let mut front = Self { topology, positions, rim, side: 0.0, moved: 0.0 };
        front.part()?;
        let sides = front.topology.edges();
        let length = |&[a, b]: &[u32; 2]| front.positions[a as usize].distance(front.positions[b as usize]);
        front.side = sides.iter().map(length).sum::<f64>() / sides.len() as f64;
        Ok(front)
    }

    /// Smooths what goes through itself until it does not.
    fn part(&mut self) -> Result<(), SolidError> {
        let triangles = self.topology.triangles();
        let mut pairs = crossings(triangles, &self.positions);
        if pairs.is_empty() {
            return Ok(());
        }
        let before = self.positions.clone();
        let mut touched = vec![false; before.len()];
        for round in 0..MOST_ROUNDS {
            for &triangle in pairs.as_flattened() {
                triangles[triangle as usize].iter().for_each(|&corner| touched[corner as usize] = true);
            }
            if round % ROUNDS_A_RING == ROUNDS_A_RING - 1 {
                touched = grown(&self.topology, &touched);
            }
            let parted = pairs.is_empty();
            // What has come apart by a hair goes further apart, so that there is room for a wall between.
            let sweeps = if parted { (before.len() / VERTICES_A_SWEEP).clamp(4, 32) } else { 1 };
            for _ in 0..sweeps {
                self.positions = smoothed(self, &touched);
            }
            let moved = |triangle: u32| triangles[triangle as usize].iter().any(|&corner| touched[corner as usize]);
            pairs = crossings_of(triangles, &self.positions, moved);
            if pairs.is_empty() && parted {
                self.moved = farthest(&before, &self.positions);
                return Ok(());
            }
        }
        Err(SolidError::CrossesItself { pairs: pairs.len() })
    }
}

/// The rims of a disc with holes, longest first.
fn checked_rims(topology: &Topology) -> Result<Vec<Vec<u32>>, SolidError> {
    let mut seen = HashSet::new();
    for &[a, b, c] in topology.triangles() {
        if let Some([from, to]) = [[a, b], [b, c], [c, a]].into_iter().find(|side| !seen.insert(*side)) {
            return Err(SolidError::NotASurface { from, to });
        }
    }
    let rims = topology.boundary_loops();
    let mut on_rim = HashSet::new();
    if let Some(&vertex) = rims.iter().flatten().find(|vertex| !on_rim.insert(**vertex)) {
        return Err(SolidError::Pinched { vertex });
    }
    let pieces = topology.components().iter().collect::<HashSet<_>>().len();
    let count = |many: usize| many as i64;
    let euler = count(topology.vertex_count()) - count(topology.edges().len()) + count(topology.triangles().len());
    match pieces == 1 && !rims.is_empty() && euler + count(rims.len()) == 2 {
        true => Ok(rims),
        false => Err(SolidError::NotADisc { pieces, rims: rims.len(), euler }),
    }
}

/// Marks what is beside marked vertices, too.
pub(crate) fn grown(topology: &Topology, marked: &[bool]) -> Vec<bool> {
    let beside = |vertex: u32| topology.neighbours(vertex).iter().any(|&next| marked[next as usize]);
    (0..marked.len() as u32).map(|vertex| marked[vertex as usize] || beside(vertex)).collect()
}

/// Each marked vertex half-way to the middle of its neighbours; on the rim, of those along it.
fn smoothed(front: &Front, marked: &[bool]) -> Vec<DVec3> {
    let mut places = front.positions.clone();
    let on_rim: HashSet<u32> = front.rim.iter().copied().collect();
    for vertex in (0..marked.len() as u32).filter(|&vertex| marked[vertex as usize] && !on_rim.contains(&vertex)) {
        let neighbours = front.topology.neighbours(vertex);
        let sum: DVec3 = neighbours.iter().map(|&next| front.positions[next as usize]).sum();
        places[vertex as usize] = places[vertex as usize].midpoint(sum / neighbours.len() as f64);
    }
    let count = front.rim.len();
    for (at, &vertex) in front.rim.iter().enumerate().filter(|(_, vertex)| marked[**vertex as usize]) {
        let [before, after] = [at + count - 1, at + 1].map(|at| front.positions[front.rim[at % count] as usize]);
        places[vertex as usize] = places[vertex as usize].midpoint(before.midpoint(after));
    }
    places
}

/// How far a vertex of the one is from where the other has it, at most; what either has more of is passed over.
pub(crate) fn farthest(one: &[DVec3], other: &[DVec3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}
