use glam::{DMat3, DVec2, DVec3};
use rosto_export::about;
use rosto_studio::project;

use super::{MM_PER_M, OpenFace};
use crate::SessionError;

/// Less of an expression is not seen.
const LEAST_SEEN: f64 = 1e-3;

/// What is shown and written of it.
impl OpenFace {
    /// The edits as versioned JSON.
    pub fn history_json(&self) -> String {
        project::to_json(self.document.history().entries())
    }

    /// Positions in MediaPipe's normalised picture coordinates.
    pub fn positions_image(&self) -> Vec<DVec3> {
        let image_from_model: DMat3 = self.model.image_from_model();
        let moved = self.document.positions().iter().zip(self.document.rest());
        let moved = moved.map(|(now, before)| image_from_model * (*now - *before));
        let rest = self.document.from_cage(self.model.positions_image());
        rest.into_iter().zip(moved).map(|(before, moved)| before + moved).collect()
    }

    /// Positions in millimetres.
    pub fn positions_mm(&self) -> Vec<DVec3> {
        self.document.positions().iter().map(|&position| position * MM_PER_M).collect()
    }

    /// What is known of the face beside its mesh, as JSON ([`about`]); measures are those of the landmarks as they are edited.
    pub fn about_json(&self) -> String {
        about(&self.model, self.document.cage()).to_string()
    }

    /// From one vertex shown to another in mm: straight, and along the surface. Landmarks are where the cage has them, however
    /// dense the mesh is.
    ///
    /// # Errors
    /// [`SessionError::Studio`] for a vertex that is not there.
    pub fn measured_mm(&self, from: u32, to: u32) -> Result<[f64; 2], SessionError> {
        let along_m = self.document.along_surface(from, to)?;
        let cage = self.document.cage();
        let positions = if (from.max(to) as usize) < cage.len() { cage } else { self.document.committed() };
        let straight_m = positions[from as usize].distance(positions[to as usize]);
        // The heat method has an error of its own; nothing on a surface is nearer than straight.
        Ok([straight_m, along_m.max(straight_m)].map(|length_m| length_m * MM_PER_M))
    }

    /// Whether the face shows an expression, or one is being moved.
    pub fn shows_expression(&self) -> bool {
        self.expression().is_some() || self.weights().iter().any(|weight| weight.abs() > LEAST_SEEN)
    }

    /// Places in the picture for every vertex shown.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.model.uvs())
    }

    /// Colours for every vertex shown: the landmarks' own, and the photo's for those that were added between them.
    pub fn colours_srgb(&self, uvs: &[DVec2]) -> Vec<[u8; 3]> {
        self.model.colours_under(uvs)
    }

    /// For each vertex shown, how much longer its edges are than in the face as it was found: −1 for 20 % or more
    /// shorter, 1 for 20 % or more longer.
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
