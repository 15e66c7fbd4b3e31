use std::fmt;

use glam::DVec3;
use rosto_mesh::Topology;

use crate::{LaplacianSystem, Peak, peaks};

/// How much an edit bent a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Distortion {
    /// For each vertex `‖δ' − δ‖`, in the positions' unit: how much its place among its neighbours changed.
    pub delta_change: Vec<f64>,
    /// For each of [`Topology::edges`], its length over what it was; 1 for an edge that had none.
    pub edge_stretch: Vec<f64>,
    /// For each triangle, its area over what it was; 1 for a triangle that had none.
    pub area_ratio: Vec<f64>,
    /// Triangles whose normal has turned by more than a right angle.
    pub flipped: Vec<u32>,
    /// Vertices that rise without taking their neighbours along.
    pub peaks: Vec<Peak>,
}

/// A distortion in a few numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistortionSummary {
    /// The vertex with the greatest `‖δ' − δ‖`.
    pub delta_change: Extreme,
    /// `‖K X' − K X‖` over the whole mesh, in the positions' unit.
    pub delta_residual: f64,
    /// The edge that shrank most.
    pub least_stretch: Extreme,
    /// The edge that grew most.
    pub greatest_stretch: Extreme,
    /// The triangle that shrank most.
    pub least_area: Extreme,
    /// The triangle that grew most.
    pub greatest_area: Extreme,
    /// How many triangles turned over, of how many.
    pub flipped: (usize, usize),
    /// How many vertices stand alone.
    pub peaks: usize,
}

/// The greatest or least of many values, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Index of the vertex, edge or triangle.
    pub index: usize,
    /// Its value.
    pub value: f64,
}

impl Distortion {
    /// Compares a mesh before and after an edit made with `system`.
    ///
    /// # Panics
    /// If there is not one position for each vertex.
    pub fn measure(topology: &Topology, system: &LaplacianSystem, before: &[DVec3], after: &[DVec3]) -> Self {
        let moved: Vec<DVec3> = after.iter().zip(before).map(|(after, before)| after - before).collect();
        let length = |at: &[DVec3], [a, b]: [u32; 2]| at[a as usize].distance(at[b as usize]);
        let area_vector = |at: &[DVec3], corners: [u32; 3]| {
            let [a, b, c] = corners.map(|corner| at[corner as usize]);
            (b - a).cross(c - a)
        };
        let normals = topology.triangles().iter().map(|&t| (area_vector(before, t), area_vector(after, t)));
        let flipped = normals.clone().enumerate().filter(|(_, (old, new))| old.dot(*new) < 0.0);
        Self {
            delta_change: system.deltas(&moved).iter().map(|change| change.length()).collect(),
            edge_stretch: topology.edges().iter().map(|&e| ratio(length(after, e), length(before, e))).collect(),
            flipped: flipped.map(|(triangle, _)| triangle as u32).collect(),
            area_ratio: normals.map(|(old, new)| ratio(new.length(), old.length())).collect(),
            peaks: peaks(topology, &moved),
        }
    }

    /// The few numbers that tell most. For an empty list of edges or triangles the ratio is 1.
    pub fn summary(&self) -> DistortionSummary {
        DistortionSummary {
            delta_change: extreme(&self.delta_change, 0.0, |new, old| new > old),
            delta_residual: self.delta_change.iter().map(|change| change * change).sum::<f64>().sqrt(),
            least_stretch: extreme(&self.edge_stretch, 1.0, |new, old| new < old),
            greatest_stretch: extreme(&self.edge_stretch, 1.0, |new, old| new > old),
            least_area: extreme(&self.area_ratio, 1.0, |new, old| new < old),
            greatest_area: extreme(&self.area_ratio, 1.0, |new, old| new > old),
            flipped: (self.flipped.len(), self.area_ratio.len()),
            peaks: self.peaks.len(),
        }
    }
}

impl fmt::Display for DistortionSummary {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            out,
            "edges are {:.2} to {:.2} times as long, triangles {:.2} to {:.2} times as large; ",
            self.least_stretch.value, self.greatest_stretch.value, self.least_area.value, self.greatest_area.value,
        )?;
        write!(out, "{} of {} triangles turned over, {} lone peaks; ", self.flipped.0, self.flipped.1, self.peaks)?;
        write!(out, "bent most at vertex {} (by {:.2e})", self.delta_change.index, self.delta_change.value)
    }
}

fn ratio(new: f64, old: f64) -> f64 {
    if old > 0.0 { new / old } else { 1.0 }
}

fn extreme(values: &[f64], neutral: f64, beats: impl Fn(f64, f64) -> bool) -> Extreme {
    let first = Extreme { index: 0, value: values.first().copied().unwrap_or(neutral) };
    let further = |best: Extreme, (index, &value): (usize, &f64)| {
        if beats(value, best.value) { Extreme { index, value } } else { best }
    };
    values.iter().enumerate().fold(first, further)
}
