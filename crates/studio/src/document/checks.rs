use std::collections::HashSet;

use rosto_face::MAX_DENSITY;
use rosto_laplacian::LaplacianError;

use super::{Document, MAX_LABEL_CHARS};
use crate::{Command, EditSpec, Entry, StudioError};

/// Default subdivision level: 7,257 vertices, with the landmarks as the cage. Rim and silhouette look smooth at this
/// density without a noticeable delay.
pub const SMOOTH_DENSITY: u32 = 2;

/// Limit on the response values of one edit: handles × vertices of its mesh.
const MAX_RESPONSES: usize = 16_000_000;

/// Validation of an entry before it is applied, whether or not it is in force.
impl Document {
    /// Rejects an entry that cannot be applied at its own density either.
    pub(super) fn check(&self, entry: &Entry) -> Result<(), StudioError> {
        let found = entry.label.chars().count();
        if found > MAX_LABEL_CHARS {
            return Err(StudioError::LabelTooLong { found, max: MAX_LABEL_CHARS });
        }
        match &entry.command {
            Command::Symmetrise { share } if (0.0..=1.0).contains(share) => Ok(()),
            &Command::Symmetrise { share } => Err(StudioError::Share { share }),
            &Command::Express { weight, .. } => self.check_expression(weight),
            Command::Move { spec, offsets } => {
                self.check_spec(spec)?;
                let (expected, found) = (spec.handles.len(), offsets.len());
                if expected != found {
                    return Err(StudioError::WrongOffsetCount { expected, found });
                }
                match offsets.iter().position(|offset| !offset.is_finite()) {
                    Some(index) => Err(StudioError::OffsetNotFinite { handle: spec.handles[index] }),
                    None => Ok(()),
                }
            }
        }
    }

    /// Rejects weights outside −1..=1, and any weight on a mesh that is not a face in the model's frame.
    pub(super) fn check_expression(&self, weight: f64) -> Result<(), StudioError> {
        match self.levels[0].mirror() {
            Err(_) => Err(StudioError::NoExpressions { vertex_count: self.levels[0].rest().len() }),
            Ok(_) if !(-1.0..=1.0).contains(&weight) => Err(StudioError::Weight { weight }),
            Ok(_) => Ok(()),
        }
    }

    /// Rejects a spec with an unknown or repeated vertex, or with too many handles for the memory limit.
    pub(super) fn check_spec(&self, spec: &EditSpec) -> Result<(), StudioError> {
        let vertex_count = self.vertices_at(spec.level)?;
        let pins = &spec.settings.anchors.pins;
        if pins.len() > vertex_count {
            return Err(StudioError::TooManyAnchors { anchors: pins.len(), vertex_count });
        }
        if let Some(&vertex) = spec.handles.iter().chain(pins).find(|vertex| **vertex as usize >= vertex_count) {
            return Err(LaplacianError::NoSuchVertex { vertex, vertex_count }.into());
        }
        if let Some(vertex) = repeated(&spec.handles) {
            return Err(LaplacianError::Repeated { vertex }.into());
        }
        let (handles, max) = (spec.handles.len(), MAX_RESPONSES / vertex_count);
        if handles > max { Err(StudioError::TooManyHandles { handles, max }) } else { Ok(()) }
    }

    /// Number of vertices of the cage after `level` subdivisions. Each adds a vertex per edge; the next edges are the
    /// halves of the edges and three inside each triangle.
    pub(super) fn vertices_at(&self, level: u32) -> Result<usize, StudioError> {
        if level > MAX_DENSITY {
            return Err(StudioError::TooDense { level, max: MAX_DENSITY });
        }
        let cage = self.levels[0].topology();
        let (mut vertices, mut edges, mut triangles) =
            (cage.vertex_count(), cage.edges().len(), cage.triangles().len());
        for _ in 0..level {
            (vertices, edges, triangles) = (vertices + edges, 2 * edges + 3 * triangles, 4 * triangles);
        }
        Ok(vertices)
    }
}

/// Returns a vertex that is listed more than once.
fn repeated(vertices: &[u32]) -> Option<u32> {
    let mut seen = HashSet::new();
    vertices.iter().copied().find(|&vertex| !seen.insert(vertex))
}
