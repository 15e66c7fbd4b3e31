use glam::DVec2;
use rosto_mesh::Topology;

use crate::layout::Tie;

/// Shortens offsets until no triangle of a flat triangulation is turned over.
///
/// An offset that all neighbours share folds nothing: around triangles that would fold, offsets become more like those
/// beside them, as heat spreads; what is still folded then takes all offsets back by one share.
pub(crate) struct Unfolding {
    topology: Topology,
    places: Vec<DVec2>,
    stays: Vec<bool>,
    leads: Vec<bool>,
}

/// A triangle keeps at least this share of its area, so that what is in it can still be seen.
const LEAST_AREA: f64 = 0.12;
/// Rounds of spreading, and of halving.
const ROUNDS: usize = 80;
const HALVINGS: usize = 24;

impl Unfolding {
    pub(crate) fn new(topology: &Topology, places: &[DVec2], ties: &[Tie]) -> Self {
        let stays = ties.iter().map(|tie| *tie == Tie::Stays).collect();
        let leads = ties.iter().map(|tie| matches!(tie, Tie::Follows { .. })).collect();
        Self { topology: topology.clone(), places: places.to_vec(), stays, leads }
    }

    /// Returns the longest way in px by which the offset of a point that leads was shortened.
    pub(crate) fn limit(&self, offsets: &mut [DVec2]) -> f64 {
        let mut folded = self.folded(offsets);
        if folded.is_empty() {
            return 0.0;
        }
        let wanted = offsets.to_vec();
        for _ in 0..ROUNDS {
            self.spread(&folded, offsets);
            folded = self.folded(offsets);
            if folded.is_empty() {
                break;
            }
        }
        if !folded.is_empty() {
            self.shorten(offsets);
        }
        let leading = offsets.iter().zip(&wanted).zip(&self.leads).filter(|(_, leads)| **leads);
        leading.map(|((now, wanted), _)| now.distance(*wanted)).fold(0.0, f64::max)
    }

    /// Corners of triangles that are turned over, or as good as: each once.
    fn folded(&self, offsets: &[DVec2]) -> Vec<u32> {
        let is_folded = |corners: &&[u32; 3]| {
            let before = doubled_area(corners.map(|corner| self.places[corner as usize]));
            let after = doubled_area(corners.map(|corner| self.places[corner as usize] + offsets[corner as usize]));
            after * before.signum() < LEAST_AREA * before.abs()
        };
        let mut corners: Vec<u32> = self.topology.triangles().iter().filter(is_folded).flatten().copied().collect();
        corners.sort_unstable();
        corners.dedup();
        corners
    }

    fn spread(&self, folded: &[u32], offsets: &mut [DVec2]) {
        let mean = |vertex: u32| {
            let neighbours = self.topology.neighbours(vertex);
            neighbours.iter().map(|&other| offsets[other as usize]).sum::<DVec2>() / neighbours.len() as f64
        };
        let moving = folded.iter().filter(|&&vertex| !self.stays[vertex as usize]);
        let means: Vec<(u32, DVec2)> = moving.map(|&vertex| (vertex, mean(vertex))).collect();
        for (vertex, mean) in means {
            offsets[vertex as usize] = 0.5 * (offsets[vertex as usize] + mean);
        }
    }

    /// The largest share of all offsets that folds nothing.
    fn shorten(&self, offsets: &mut [DVec2]) {
        let scaled = |share: f64| offsets.iter().map(|offset| *offset * share).collect::<Vec<_>>();
        let (mut fits, mut folds) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let share = 0.5 * (fits + folds);
            if self.folded(&scaled(share)).is_empty() { fits = share } else { folds = share }
        }
        let fitting = scaled(fits);
        offsets.copy_from_slice(&fitting);
    }
}

/// Twice the area with its sign.
pub(crate) fn doubled_area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}
