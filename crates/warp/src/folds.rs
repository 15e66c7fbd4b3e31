use glam::DVec2;
use rosto_mesh::Topology;

use crate::layout::Tie;

/// Shortens offsets until no triangle of a flat triangulation is turned over.
///
/// An offset that all neighbours share folds nothing: around triangles that would fold, offsets become more like those
/// beside them, as heat spreads; what is still folded then takes all offsets back by one share.
pub(crate) struct Unfolding {
    topology: Topology,
    /// Those that can move.
    triangles: Vec<Flat>,
    /// For each vertex, where its triangles begin in `at_vertices`.
    starts: Vec<usize>,
    at_vertices: Vec<u32>,
    stays: Vec<bool>,
    leads: Vec<bool>,
    work: Work,
}

/// A triangle before anything moved: two of its edges, from its first corner, and twice its area.
struct Flat {
    corners: [u32; 3],
    edges: [DVec2; 2],
    doubled_area: f64,
}

/// What is folded, and room to work in: a tick allocates nothing.
#[derive(Default)]
struct Work {
    folded: Vec<u32>,
    corners: Vec<u32>,
    means: Vec<DVec2>,
    wanted: Vec<DVec2>,
}

/// A triangle keeps at least this share of its area, so that what is in it can still be seen.
const LEAST_AREA: f64 = 0.12;
/// Rounds of spreading, and of halving.
const ROUNDS: usize = 80;
const HALVINGS: usize = 24;

impl Unfolding {
    pub(crate) fn new(topology: &Topology, places: &[DVec2], ties: &[Tie]) -> Self {
        let stays: Vec<bool> = ties.iter().map(|tie| *tie == Tie::Stays).collect();
        let leads = ties.iter().map(|tie| matches!(tie, Tie::Follows { .. })).collect();
        let can_move = |corners: &&[u32; 3]| corners.iter().any(|&corner| !stays[corner as usize]);
        let triangles: Vec<Flat> =
            topology.triangles().iter().filter(can_move).map(|&corners| Flat::new(corners, places)).collect();
        let (starts, at_vertices) = by_vertex(&triangles, places.len());
        Self { topology: topology.clone(), triangles, starts, at_vertices, stays, leads, work: Work::default() }
    }

    /// Returns the longest way in px by which the offset of a point that leads was shortened.
    pub(crate) fn limit(&mut self, offsets: &mut [DVec2]) -> f64 {
        let mut work = std::mem::take(&mut self.work);
        let limited_px = self.limit_in(&mut work, offsets);
        self.work = work;
        limited_px
    }

    fn limit_in(&self, work: &mut Work, offsets: &mut [DVec2]) -> f64 {
        work.folded.clear();
        work.folded.extend((0..self.triangles.len() as u32).filter(|&triangle| self.is_folded(triangle, offsets)));
        if work.folded.is_empty() {
            return 0.0;
        }
        work.wanted.clear();
        work.wanted.extend_from_slice(offsets);
        for _ in 0..ROUNDS {
            self.spread(work, offsets);
            if work.folded.is_empty() {
                break;
            }
        }
        if !work.folded.is_empty() {
            self.shorten(offsets);
        }
        let leading = offsets.iter().zip(&work.wanted).zip(&self.leads).filter(|(_, leads)| **leads);
        leading.map(|((now, wanted), _)| now.distance(*wanted)).fold(0.0, f64::max)
    }

    /// Whether it is turned over, or as good as.
    fn is_folded(&self, triangle: u32, offsets: &[DVec2]) -> bool {
        let flat = &self.triangles[triangle as usize];
        flat.after(offsets) * flat.doubled_area.signum() < LEAST_AREA * flat.doubled_area.abs()
    }

    /// One round: corners of what is folded go half the way to the mean of their neighbours. Only beside them can anything
    /// have changed.
    fn spread(&self, work: &mut Work, offsets: &mut [DVec2]) {
        let Work { folded, corners, means, .. } = work;
        corners.clear();
        corners.extend(folded.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners));
        corners.retain(|&vertex| !self.stays[vertex as usize]);
        sort_once(corners);
        means.clear();
        means.extend(corners.iter().map(|&vertex| self.mean(vertex, offsets)));
        for (&vertex, mean) in corners.iter().zip(means) {
            offsets[vertex as usize] = 0.5 * (offsets[vertex as usize] + *mean);
        }
        folded.clear();
        folded.extend(corners.iter().flat_map(|&vertex| self.triangles_at(vertex)));
        sort_once(folded);
        folded.retain(|&triangle| self.is_folded(triangle, offsets));
    }

    fn mean(&self, vertex: u32, offsets: &[DVec2]) -> DVec2 {
        let neighbours = self.topology.neighbours(vertex);
        neighbours.iter().map(|&other| offsets[other as usize]).sum::<DVec2>() / neighbours.len() as f64
    }

    fn triangles_at(&self, vertex: u32) -> &[u32] {
        &self.at_vertices[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }

    /// The largest share of all offsets that folds nothing; at none of them nothing is folded.
    fn shorten(&self, offsets: &mut [DVec2]) {
        let (mut fits, mut folds) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let share = 0.5 * (fits + folds);
            match self.triangles.iter().all(|flat| flat.fits_at(share, offsets)) {
                true => fits = share,
                false => folds = share,
            }
        }
        offsets.iter_mut().for_each(|offset| *offset *= fits);
    }
}

impl Flat {
    fn new(corners: [u32; 3], places: &[DVec2]) -> Self {
        let [a, b, c] = corners.map(|corner| places[corner as usize]);
        Self { corners, edges: [b - a, c - a], doubled_area: doubled_area([a, b, c]) }
    }

    /// Twice its area with these offsets.
    fn after(&self, offsets: &[DVec2]) -> f64 {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize]);
        (self.edges[0] + (b - a)).perp_dot(self.edges[1] + (c - a))
    }

    /// Whether it is not folded with so much of the offsets.
    fn fits_at(&self, share: f64, offsets: &[DVec2]) -> bool {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize] * share);
        let after = (self.edges[0] + (b - a)).perp_dot(self.edges[1] + (c - a));
        after * self.doubled_area.signum() >= LEAST_AREA * self.doubled_area.abs()
    }
}

/// The triangles at each vertex, and where they begin.
fn by_vertex(triangles: &[Flat], vertices: usize) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; vertices + 1];
    let corners =
        || triangles.iter().zip(0..).flat_map(|(flat, triangle)| flat.corners.map(|corner| (corner, triangle)));
    corners().for_each(|(corner, _)| starts[corner as usize + 1] += 1);
    (0..vertices).for_each(|vertex| starts[vertex + 1] += starts[vertex]);
    let (mut next, mut at_vertices) = (starts.clone(), vec![0; 3 * triangles.len()]);
    for (corner, triangle) in corners() {
        at_vertices[next[corner as usize]] = triangle;
        next[corner as usize] += 1;
    }
    (starts, at_vertices)
}

fn sort_once(values: &mut Vec<u32>) {
    values.sort_unstable();
    values.dedup();
}

/// Twice the area with its sign.
pub(crate) fn doubled_area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}
