//! The front of a body: a validated surface with filled openings and without self-intersections.

use std::collections::HashSet;

use glam::DVec3;
use rosto_mesh::{Surface, Topology};

use crate::crossings::{crossings, crossings_of};
use crate::{SolidError, filling};

/// Maximum number of smoothing rounds.
const MAX_ROUNDS: usize = 120;

/// Number of rounds after which the smoothed area grows by a ring.
const ROUNDS_PER_RING: usize = 6;

/// After the last intersection, smoothing continues for one sweep per this many vertices, within bounds, since a sweep
/// moves vertices of a denser mesh less.
const VERTICES_PER_SWEEP: usize = 100;

/// A disc: one rim, no unused vertices, no self-intersections.
pub(crate) struct Front {
    pub topology: Topology,
    pub positions: Vec<DVec3>,
    /// The rim, with the surface on its left.
    pub rim: Vec<u32>,
    /// Mean edge length.
    pub side: f64,
    /// Largest displacement of a vertex by smoothing.
    pub moved: f64,
}

impl Front {
    pub(crate) fn new(surface: Surface<'_>) -> Result<Self, SolidError> {
        let positions = surface.positions().to_vec();
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(SolidError::NotFinite { vertex });
        }
        let mut rims = checked_rims(surface.topology())?;
        let rim = rims.remove(0);
        let mut triangles = surface.topology().triangles().to_vec();
        for mut opening in rims {
            // The filling is on the other side of the boundary edges.
            opening.reverse();
            let points: Vec<DVec3> = opening.iter().map(|&vertex| positions[vertex as usize]).collect();
            triangles.extend(filling::least_area(&points).iter().map(|corners| corners.map(|at| opening[at])));
        }
        let topology = Topology::new(positions.len(), triangles)?;
        let mut front = Self { topology, positions, rim, side: 0.0, moved: 0.0 };
        front.separate()?;
        let sides = front.topology.edges();
        let length = |&[a, b]: &[u32; 2]| front.positions[a as usize].distance(front.positions[b as usize]);
        front.side = sides.iter().map(length).sum::<f64>() / sides.len() as f64;
        Ok(front)
    }

    /// Smooths intersecting parts until they separate.
    fn separate(&mut self) -> Result<(), SolidError> {
        let triangles = self.topology.triangles();
        let mut pairs = crossings(triangles, &self.positions);
        if pairs.is_empty() {
            return Ok(());
        }
        let before = self.positions.clone();
        let mut touched = vec![false; before.len()];
        for round in 0..MAX_ROUNDS {
            for &triangle in pairs.as_flattened() {
                triangles[triangle as usize].iter().for_each(|&corner| touched[corner as usize] = true);
            }
            if round % ROUNDS_PER_RING == ROUNDS_PER_RING - 1 {
                touched = dilated(&self.topology, &touched);
            }
            let separated = pairs.is_empty();
            // Barely separated parts are moved further apart, so that there is room for a wall.
            let sweeps = if separated { (before.len() / VERTICES_PER_SWEEP).clamp(4, 32) } else { 1 };
            for _ in 0..sweeps {
                self.positions = smoothed(self, &touched);
            }
            let moved = |triangle: u32| triangles[triangle as usize].iter().any(|&corner| touched[corner as usize]);
            pairs = crossings_of(triangles, &self.positions, moved);
            if pairs.is_empty() && separated {
                self.moved = farthest(&before, &self.positions);
                return Ok(());
            }
        }
        Err(SolidError::CrossesItself { pairs: pairs.len() })
    }
}

/// Rims of a disc with holes, longest first.
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

/// Also marks the neighbours of marked vertices.
pub(crate) fn dilated(topology: &Topology, marked: &[bool]) -> Vec<bool> {
    let is_adjacent = |vertex: u32| topology.neighbours(vertex).iter().any(|&next| marked[next as usize]);
    (0..marked.len() as u32).map(|vertex| marked[vertex as usize] || is_adjacent(vertex)).collect()
}

/// Moves each marked vertex halfway to the mean of its neighbours; rim vertices along the rim.
fn smoothed(front: &Front, marked: &[bool]) -> Vec<DVec3> {
    let mut smoothed = front.positions.clone();
    let on_rim: HashSet<u32> = front.rim.iter().copied().collect();
    for vertex in (0..marked.len() as u32).filter(|&vertex| marked[vertex as usize] && !on_rim.contains(&vertex)) {
        let neighbours = front.topology.neighbours(vertex);
        let sum: DVec3 = neighbours.iter().map(|&next| front.positions[next as usize]).sum();
        smoothed[vertex as usize] = smoothed[vertex as usize].midpoint(sum / neighbours.len() as f64);
    }
    let count = front.rim.len();
    for (at, &vertex) in front.rim.iter().enumerate().filter(|(_, vertex)| marked[**vertex as usize]) {
        let [before, after] = [at + count - 1, at + 1].map(|at| front.positions[front.rim[at % count] as usize]);
        smoothed[vertex as usize] = smoothed[vertex as usize].midpoint(before.midpoint(after));
    }
    smoothed
}

/// Largest distance between corresponding vertices; extra vertices are ignored.
pub(crate) fn farthest(one: &[DVec3], other: &[DVec3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}
