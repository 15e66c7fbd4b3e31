use glam::DVec3;
use rosto_mesh::Topology;

/// Mean displacement of the neighbours, as a share of the summit's, below which the summit is a peak.
const GRADUAL_SHARE: f64 = 0.5;

/// Least height of a peak over its neighbours, as a share of the greatest displacement.
const LEAST_RISE: f64 = 0.05;

/// A vertex that moved further than its neighbours, without a gradual rise around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The vertex.
    pub vertex: u32,
    /// Mean displacement of its neighbours along its own, as a share of it: below ½, and negative if they move the
    /// opposite direction.
    pub share: f64,
}

/// Finds peaks by the paper's criterion: "any peaks on a face without a gradual rise would be unnatural".
///
/// A summit is a vertex that moved further than each neighbour. Its rise is gradual if the neighbours' displacements,
/// projected on its own, average at least half of it. Otherwise the summit is a peak, if it exceeds its neighbours by
/// at least 5 % of the greatest displacement. `moved` holds one displacement per vertex.
///
/// # Panics
/// If the numbers of displacements and vertices differ.
pub fn peaks(topology: &Topology, moved: &[DVec3]) -> Vec<Peak> {
    assert_eq!(moved.len(), topology.vertex_count(), "one displacement for each vertex");
    let greatest = moved.iter().map(|moved| moved.length()).fold(0.0, f64::max);
    let summits = (0..moved.len() as u32).filter(|&vertex| is_summit(topology, moved, vertex));
    let peaks = summits.map(|vertex| Peak { vertex, share: followed_share(topology, moved, vertex) });
    let stands_out = |peak: &Peak| (1.0 - peak.share) * moved[peak.vertex as usize].length() >= LEAST_RISE * greatest;
    peaks.filter(|peak| peak.share < GRADUAL_SHARE && stands_out(peak)).collect()
}

fn is_summit(topology: &Topology, moved: &[DVec3], vertex: u32) -> bool {
    let height = moved[vertex as usize].length();
    let neighbours = topology.neighbours(vertex);
    !neighbours.is_empty() && neighbours.iter().all(|&neighbour| moved[neighbour as usize].length() < height)
}

fn followed_share(topology: &Topology, moved: &[DVec3], vertex: u32) -> f64 {
    let own = moved[vertex as usize];
    let (direction, height) = (own.normalize(), own.length());
    let neighbours = topology.neighbours(vertex);
    let along: f64 = neighbours.iter().map(|&neighbour| moved[neighbour as usize].dot(direction) / height).sum();
    along / neighbours.len() as f64
}
