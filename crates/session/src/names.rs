use rosto_face::LANDMARK_COUNT;
use rosto_studio::EditTarget;

use crate::{Session, SessionError};

/// What things are, for who names them.
impl Session {
    /// What a drag that starts at a vertex moves: what is selected, if the vertex is part of it, or what is selected there.
    ///
    /// # Errors
    /// [`SessionError::NoSuchVertex`].
    pub fn target_at(&self, vertex: u32) -> Result<EditTarget, SessionError> {
        let Some(face) = self.face() else { return Ok(EditTarget::Landmark(known_landmark(vertex)?)) };
        let selection = face.at_or_grabbed(face.known(vertex, self.mode())?, self.mode());
        Ok(selection.target())
    }

    /// What is selected.
    pub fn selected_target(&self) -> Option<EditTarget> {
        self.face()?.selection().map(crate::Selection::target)
    }
}

/// Refuses a landmark that is not there.
///
/// # Errors
/// [`SessionError::NoSuchVertex`].
fn known_landmark(vertex: u32) -> Result<u32, SessionError> {
    let count = LANDMARK_COUNT;
    if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
}
