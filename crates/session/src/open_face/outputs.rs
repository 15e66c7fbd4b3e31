use glam::DVec2;
use rosto_export::about;
use rosto_studio::project;

use super::{MM_PER_M, OpenFace};
use crate::SessionError;

/// Weights below this are not visible.
const MIN_VISIBLE: f64 = 1e-3;

/// Data for display and files.
impl OpenFace {
    /// The edits as versioned JSON.
    pub fn history_json(&self) -> String {
        project::to_json(self.document.history().entries())
    }

    /// Data of the face apart from its mesh, as JSON ([`about`]); measures use the edited landmarks.
    pub fn about_json(&self) -> String {
        about(&self.model, self.document.cage()).to_string()
    }

    /// Distance between two displayed vertices in mm, straight and along the surface. Between landmarks it is measured
    /// on the cage, at any density.
    ///
    /// # Errors
    /// [`SessionError::Studio`] if a vertex does not exist.
    pub fn measured_mm(&self, from: u32, to: u32) -> Result<[f64; 2], SessionError> {
        let along_m = self.document.along_surface(from, to)?;
        let cage = self.document.cage();
        let positions = if (from.max(to) as usize) < cage.len() { cage } else { self.document.committed() };
        let straight_m = positions[from as usize].distance(positions[to as usize]);
        // The heat method is approximate; the straight distance is a lower bound.
        Ok([straight_m, along_m.max(straight_m)].map(|length_m| length_m * MM_PER_M))
    }

    /// Whether the face has an expression, including one being moved.
    pub fn shows_expression(&self) -> bool {
        self.expression().is_some() || self.weights().iter().any(|weight| weight.abs() > MIN_VISIBLE)
    }

    /// Texture coordinates in the picture of each displayed vertex.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.model.uvs())
    }

    /// Colour of each displayed vertex, interpolated from those of the landmarks.
    pub fn colours_srgb(&self) -> Vec<[u8; 3]> {
        rosto_studio::vertex_colours(&self.model, &self.document)
    }

    /// Numbers of vertices and triangles of the displayed mesh, or of the mesh with eyes and mouth in separate pieces.
    pub fn mesh_counts(&self, has_pieces: bool) -> [usize; 2] {
        let split = has_pieces.then(|| self.document.split_face());
        let topology = split.as_ref().map_or(self.document.topology(), |split| split.topology());
        [topology.vertex_count(), topology.triangles().len()]
    }

    /// Relative change in the length of each displayed vertex's edges, scaled so that ±20 % is ±1 and clamped.
    pub fn stretch(&self) -> Vec<f64> {
        let (topology, rest, now) = (self.document.topology(), self.document.rest(), self.document.positions());
        let mut sums = vec![(0.0, 0.0); topology.vertex_count()];
        for edge in topology.edges() {
            let [a, b] = edge.map(|end| end as usize);
            let (before, after) = (rest[a].distance(rest[b]), now[a].distance(now[b]));
            for end in [a, b] {
                sums[end].0 += before;
                sums[end].1 += after;
            }
        }
        let ratio = |(before, after): (f64, f64)| if before > 0.0 { after / before - 1.0 } else { 0.0 };
        sums.into_iter().map(|sum| (ratio(sum) / 0.2).clamp(-1.0, 1.0)).collect()
    }
}
