use std::iter::Sum;
use std::ops::Mul;

use glam::DVec2;

use crate::map::{AREA, CELLS};
use crate::raster::spans;
use crate::{Subject, TextureError};

/// The mesh laid out in its texture, at the size of a map.
pub(crate) struct Atlas {
    /// For each cell whose middle shows the mesh, the corners of its triangle and their shares there.
    cells: Vec<Option<([u32; 3], [f64; 3])>>,
}

impl Atlas {
    /// # Errors
    /// [`TextureError::NoArea`] if no cell shows it.
    pub(crate) fn new(subject: &Subject<'_>) -> Result<Self, TextureError> {
        let mut cells = vec![None; AREA];
        for &corners in subject.topology.triangles() {
            let places = corners.map(|corner| subject.atlas_uvs[corner as usize] * CELLS as f64);
            for span in spans(places, [CELLS; 2]) {
                for (column, shares) in span.pixels() {
                    cells[span.row * CELLS + column] = Some((corners, shares.to_array()));
                }
            }
        }
        if cells.iter().all(Option::is_none) { Err(TextureError::NoArea) } else { Ok(Self { cells }) }
    }

    /// Whether each cell shows the mesh.
    pub(crate) fn is_inside(&self, cell: usize) -> bool {
        self.cells[cell].is_some()
    }

    /// A value of the vertices in each cell of the mesh, between its corners.
    pub(crate) fn spread<T: Copy + Mul<f64, Output = T> + Sum>(&self, of_vertices: &[T]) -> Vec<Option<T>> {
        let between = |(corners, shares): ([u32; 3], [f64; 3])| {
            corners.into_iter().zip(shares).map(|(corner, share)| of_vertices[corner as usize] * share).sum()
        };
        self.cells.iter().map(|cell| cell.map(between)).collect()
    }
}

/// So many px of a picture lie along one of a square of `side` px, in the mean over the mesh.
pub(crate) fn pitch(subject: &Subject<'_>, places_px: &[DVec2], side: f64) -> f64 {
    let area = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a).abs();
    let sum = |places: &[DVec2]| -> f64 {
        let triangles = subject.topology.triangles().iter();
        triangles.map(|corners| area(corners.map(|corner| places[corner as usize]))).sum()
    };
    (sum(places_px) / (sum(subject.atlas_uvs) * side * side)).sqrt()
}
