use rosto_face::{LANDMARK_COUNT, Language, landmark_name};

use crate::open_face::landmark_label;
use crate::{Session, SessionError};

/// What things are called.
impl Session {
    /// The name of what is selected.
    pub fn selection_name(&self, language: Language) -> Option<String> {
        let face = self.face()?;
        face.selection().map(|selection| face.label(selection.target(), language))
    }

    /// What a drag that starts at a vertex moves: what is selected, if the vertex is part of it, or what is selected there.
    ///
    /// # Errors
    /// [`SessionError::NoSuchVertex`].
    pub fn name_at(&self, vertex: u32, language: Language) -> Result<String, SessionError> {
        let Some(face) = self.face() else { return Ok(landmark_label(known_landmark(vertex)?, language)) };
        let selection = face.at_or_held(face.known(vertex, self.mode())?, self.mode());
        Ok(face.label(selection.target(), language))
    }

    /// The vertex that is meant by a number, or the landmark that is meant by its name, in any case of its letters; none
    /// where there is none that could be selected.
    pub fn vertex_called(&self, text: &str, language: Language) -> Option<u32> {
        let wanted = text.trim().to_lowercase();
        if let Ok(vertex) = wanted.parse::<u32>() {
            let count = self.face().map_or(LANDMARK_COUNT, |face| face.within_reach(self.mode()));
            return Some(vertex).filter(|&vertex| (vertex as usize) < count);
        }
        let ways = |landmark: u32| [landmark_name(landmark, language), landmark_label(landmark, language)];
        (0..LANDMARK_COUNT as u32).find(|&landmark| ways(landmark).iter().any(|way| way.to_lowercase() == wanted))
    }

    /// What an entry of the history works on.
    ///
    /// # Errors
    /// [`SessionError::NoFace`], or that there is no such entry.
    pub fn entry_name(&self, index: usize, language: Language) -> Result<String, SessionError> {
        let face = self.open_face()?;
        let count = face.rows().len();
        let row = face.rows().get(index).ok_or(rosto_studio::StudioError::NoSuchEntry { index, count })?;
        Ok(face.label(row.target, language))
    }
}

/// Refuses a landmark that is not there.
///
/// # Errors
/// [`SessionError::NoSuchVertex`].
pub fn known_landmark(vertex: u32) -> Result<u32, SessionError> {
    let count = LANDMARK_COUNT;
    if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
}
