use rosto_face::{LANDMARK_COUNT, landmark_id};
use rosto_studio::EditTarget;

use super::Phrase;
use crate::{Session, SessionError};

/// Names of the objects that edits work on.
impl Session {
    /// Name of an edit's target.
    pub(crate) fn name_of(&self, target: EditTarget) -> Phrase {
        let part = self.face().and_then(|face| face.document().part_of(target));
        match target {
            EditTarget::Landmark(vertex) => self.landmark_name(vertex),
            EditTarget::Point { vertex, .. } => {
                let name = match self.is_expert() {
                    true => Phrase::word("target.point").with("n", vertex.to_string()),
                    false => Phrase::word("target.point.plain"),
                };
                match part {
                    Some(part) => Phrase::word("target.near").with("name", name).with("near", word("near", &part)),
                    None => name,
                }
            }
            EditTarget::Vertices(count) => Phrase::word("target.vertices").with("n", count),
            EditTarget::Symmetry => Phrase::word("target.symmetry"),
            EditTarget::Region(_) | EditTarget::Slider(_) | EditTarget::Expression(_) => {
                word(target.kind(), &target.to_string())
            }
        }
    }

    /// Name of the selection.
    pub(crate) fn selection_name(&self) -> Option<Phrase> {
        Some(self.name_of(self.face()?.selection()?.target()))
    }

    /// Announcement of the selection.
    pub(crate) fn selected_name(&self) -> Option<Phrase> {
        Some(Phrase::word("landmark.selected").with("name", self.selection_name()?))
    }

    /// Name of what a drag that starts at a vertex moves: the selection if it contains the vertex, else what a click
    /// there selects.
    pub(crate) fn name_at(&self, vertex: u32) -> Result<Phrase, SessionError> {
        let Some(face) = self.face() else { return Ok(self.landmark_name(known_landmark(vertex)?)) };
        let selection = face.selection_around(face.known(vertex, self.mode())?, self.mode());
        Ok(self.name_of(selection.target()))
    }

    /// Anatomical name of a landmark, or the part of the face around it; with its number for experts.
    pub(crate) fn landmark_name(&self, vertex: u32) -> Phrase {
        let id = landmark_id(vertex);
        let part = id.rsplit_once('-').filter(|(_, number)| number.bytes().all(|byte| byte.is_ascii_digit()));
        let name = match part {
            Some((part, _)) => word("part", part),
            None => word("landmark", &id),
        };
        match self.is_expert() {
            true => Phrase::word("target.numbered").with("name", name).with("n", vertex.to_string()),
            false => name,
        }
    }
}

/// The word of an id.
pub(super) fn word(kind: &str, id: &str) -> Phrase {
    Phrase::word(format!("{kind}.{id}"))
}

/// Checks that a landmark exists.
///
/// # Errors
/// [`SessionError::NoSuchVertex`].
fn known_landmark(vertex: u32) -> Result<u32, SessionError> {
    let count = LANDMARK_COUNT;
    if (vertex as usize) < count { Ok(vertex) } else { Err(SessionError::NoSuchVertex { vertex, count }) }
}
