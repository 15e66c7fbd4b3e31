use rosto_face::LANDMARK_COUNT;
use rosto_studio::EditTarget;
use serde::Serialize;
use tsify::Tsify;

use crate::{Session, SessionError};

/// The object that an edit works on, for naming.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Target {
    /// "landmark", "point", "region", "slider", "vertices", "symmetry" or "expression".
    pub kind: &'static str,
    /// Id, such as "nose-tip", "left-brow" or "nose-width".
    pub id: String,
    /// Number of a landmark or point, or number of vertices.
    pub number: Option<u32>,
    /// Part of the face around a point, such as "left-cheek", if its mesh has been built.
    pub part: Option<String>,
}

/// Targets.
impl Session {
    /// Target of a drag that starts at a vertex: the selection if it contains the vertex, else what a click there
    /// selects.
    ///
    /// # Errors
    /// [`SessionError::NoSuchVertex`].
    pub fn target_at(&self, vertex: u32) -> Result<Target, SessionError> {
        let Some(face) = self.face() else { return Ok(self.target(EditTarget::Landmark(known_landmark(vertex)?))) };
        let selection = face.selection_around(face.known(vertex, self.mode())?, self.mode());
        Ok(self.target(selection.target()))
    }

    /// Target of the selection.
    pub(super) fn selected_target(&self) -> Option<Target> {
        self.face()?.selection().map(|selection| self.target(selection.target()))
    }

    pub(super) fn target(&self, target: EditTarget) -> Target {
        let number = match target {
            EditTarget::Landmark(vertex) | EditTarget::Point { vertex, .. } => Some(vertex),
            EditTarget::Vertices(count) => Some(count as u32),
            EditTarget::Region(_) | EditTarget::Slider(_) | EditTarget::Symmetry | EditTarget::Expression(_) => None,
        };
        let part = self.face().and_then(|face| face.document().part_of(target));
        Target { kind: target.kind(), id: target.to_string(), number, part }
    }
}

/// Checks that a landmark exists.
///
/// # Errors
/// [`SessionError::NoSuchVertex`].
fn known_landmark(vertex: u32) -> Result<u32, SessionError> {
    let count = LANDMARK_COUNT;
    if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
}
