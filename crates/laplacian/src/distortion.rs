use std::fmt;

use glam::DVec3;
use rosto_mesh::Topology;

use crate::{LaplacianSystem, Peak, peaks};

/// Distortion of a mesh by an edit.
#[derive(Debug, Clone, PartialEq)]
pub struct Distortion {
    /// Length of the change of each vertex's δ-coordinate, `‖δ' − δ‖`, in the positions' unit.
    pub delta_change: Vec<f64>,
    /// For each of [`Topology::edges`], its new length over its old length; 1 for edges that had length 0.
    pub edge_stretch: Vec<f64>,
    /// For each triangle, its new area over its old area; 1 for triangles that had area 0.
    pub area_ratio: Vec<f64>,
    /// Triangles whose normal turned by more than 90°.
    pub flipped: Vec<u32>,
    /// Vertices that moved without a gradual rise around them; see [`peaks()`].
    pub peaks: Vec<Peak>,
}

/// Extremes and counts of a [`Distortion`].
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
    /// Number of flipped triangles, and number of triangles.
    pub flipped: (usize, usize),
    /// Number of peaks.
    pub peaks: usize,
}

/// The greatest or least of several values, with its index.
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
    /// If the numbers of vertices and positions differ.
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

    /// Returns the extremes and counts. Without edges or triangles the ratios are 1.
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
        write!(out, "{} of {} triangles flipped, {} isolated peaks; ", self.flipped.0, self.flipped.1, self.peaks)?;
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
