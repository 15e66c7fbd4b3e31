use std::iter::Sum;
use std::ops::Mul;

use glam::DVec2;

use crate::map::{AREA, CELLS};
use crate::raster::spans;
use crate::{Subject, TextureError};

/// The mesh rasterised in its texture coordinates, at the size of a map.
pub(crate) struct Atlas {
    /// For each cell whose centre the mesh covers: the triangle's vertices and their barycentric coordinates.
    cells: Vec<Option<([u32; 3], [f64; 3])>>,
}

impl Atlas {
    /// # Errors
    /// [`TextureError::NoArea`] if the mesh covers no cell.
    pub(crate) fn new(subject: &Subject<'_>) -> Result<Self, TextureError> {
        let mut cells = vec![None; AREA];
        for &corners in subject.topology.triangles() {
            let positions = corners.map(|corner| subject.atlas_uvs[corner as usize] * CELLS as f64);
            for span in spans(positions, [CELLS; 2]) {
                for (column, shares) in span.pixels() {
                    cells[span.row * CELLS + column] = Some((corners, shares.to_array()));
                }
            }
        }
        if cells.iter().all(Option::is_none) { Err(TextureError::NoArea) } else { Ok(Self { cells }) }
    }

    /// Whether the mesh covers the cell.
    pub(crate) fn is_inside(&self, cell: usize) -> bool {
        self.cells[cell].is_some()
    }

    /// Interpolates a value per vertex to the covered cells.
    pub(crate) fn spread<T: Copy + Mul<f64, Output = T> + Sum>(&self, of_vertices: &[T]) -> Vec<Option<T>> {
        let interpolated = |(corners, shares): ([u32; 3], [f64; 3])| {
            corners.into_iter().zip(shares).map(|(corner, share)| of_vertices[corner as usize] * share).sum()
        };
        self.cells.iter().map(|cell| cell.map(interpolated)).collect()
    }
}

/// Pixels of a picture per pixel of a square texture with `side` px, averaged over the mesh.
pub(crate) fn pitch(subject: &Subject<'_>, positions_px: &[DVec2], side: f64) -> f64 {
    let area = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a).abs();
    let sum = |positions: &[DVec2]| -> f64 {
        let triangles = subject.topology.triangles().iter();
        triangles.map(|corners| area(corners.map(|corner| positions[corner as usize]))).sum()
    };
    (sum(positions_px) / (sum(subject.atlas_uvs) * side * side)).sqrt()
}
