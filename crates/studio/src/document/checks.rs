use std::collections::HashSet;

use rosto_face::MAX_DENSITY;
use rosto_laplacian::LaplacianError;

use super::Document;
use crate::{Command, EditSpec, Entry, StudioError};

/// So often a face is subdivided unless somebody chooses otherwise: 7 257 points with the landmarks as their cage. Its rim and
/// its outline against the light are smooth then, and nothing takes noticeably longer.
pub const SMOOTH_DENSITY: u32 = 2;

/// One edit solves for no more numbers than this: one for each of its handles and each vertex of its mesh.
const MOST_RESPONSES: usize = 16_000_000;

/// What can be said of an entry before it is carried out, whether or not it counts.
impl Document {
    /// Refuses an entry that could not be carried out at its own density either.
    pub(super) fn check(&self, entry: &Entry) -> Result<(), StudioError> {
        match &entry.command {
            Command::Symmetrise { share } if (0.0..=1.0).contains(share) => Ok(()),
            &Command::Symmetrise { share } => Err(StudioError::Share { share }),
            &Command::Express { weight, .. } => self.check_expression(weight),
            Command::Move { spec, offsets } => {
                self.check_grip(spec)?;
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

    /// Refuses a weight beyond what there is, and expressions of what is no face in the model's frame.
    pub(super) fn check_expression(&self, weight: f64) -> Result<(), StudioError> {
        match self.levels[0].mirror() {
            Err(_) => Err(StudioError::NoExpressions { vertex_count: self.levels[0].rest().len() }),
            Ok(_) if !(-1.0..=1.0).contains(&weight) => Err(StudioError::Weight { weight }),
            Ok(_) => Ok(()),
        }
    }

    /// Refuses a spec on what no mesh of its density has, on a vertex twice, or on more than there is memory for.
    pub(super) fn check_grip(&self, spec: &EditSpec) -> Result<(), StudioError> {
        let vertex_count = self.vertices_at(spec.level)?;
        let pins = &spec.settings.anchors.pins;
        if let Some(&vertex) = spec.handles.iter().chain(pins).find(|vertex| **vertex as usize >= vertex_count) {
            return Err(LaplacianError::NoSuchVertex { vertex, vertex_count }.into());
        }
        if let Some(vertex) = repeated(&spec.handles) {
            return Err(LaplacianError::Repeated { vertex }.into());
        }
        let (handles, most) = (spec.handles.len(), MOST_RESPONSES / vertex_count);
        if handles > most { Err(StudioError::TooManyHandles { handles, most }) } else { Ok(()) }
    }

    /// How many vertices the cage has, subdivided so many times: each time one more for each edge, whose halves and the
    /// three edges inside each triangle are the next ones.
    pub(super) fn vertices_at(&self, level: u32) -> Result<usize, StudioError> {
        if level > MAX_DENSITY {
            return Err(StudioError::TooDense { level, most: MAX_DENSITY });
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

/// A vertex that is listed more than once.
fn repeated(vertices: &[u32]) -> Option<u32> {
    let mut seen = HashSet::new();
    vertices.iter().copied().find(|&vertex| !seen.insert(vertex))
}
