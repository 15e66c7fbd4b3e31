use rosto_face::LANDMARK_COUNT;
use rosto_studio::EditTarget;

use crate::{Session, SessionError};

/// Targets, for naming.
impl Session {
    /// Target of a drag that starts at a vertex: the selection if it contains the vertex, else what a click there
    /// selects.
    ///
    /// # Errors
    /// [`SessionError::NoSuchVertex`].
    pub fn target_at(&self, vertex: u32) -> Result<EditTarget, SessionError> {
        let Some(face) = self.face() else { return Ok(EditTarget::Landmark(known_landmark(vertex)?)) };
        let selection = face.selection_around(face.known(vertex, self.mode())?, self.mode());
        Ok(selection.target())
    }

    /// Target of the selection.
    pub fn selected_target(&self) -> Option<EditTarget> {
        self.face()?.selection().map(crate::Selection::target)
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
