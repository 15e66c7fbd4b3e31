use rosto_face::{FaceModel, Turn};

use super::{OpenFace, PhotoEdit};
use crate::choices::Choices;
use crate::error::SessionError;
use crate::further_photo::FurtherPhoto;

/// One of the photos of a face, as panels show it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhotoFacts {
    /// Whether it leads: its colours, size and lens are the face's, and it is the one that is shown.
    pub leads: bool,
    /// How far the head is turned in it, in degrees: above 0 to the subject's own left.
    pub yaw_deg: f64,
    /// Which of the turns that photos are to show it is, if it is one of them.
    pub turn: Option<Turn>,
    /// Whether no photo before it, nor the one that leads, shows the face from there.
    pub adds: bool,
}

/// The photos that it was seen in.
impl OpenFace {
    /// Each in the order that they were given in.
    pub fn photos(&self) -> Vec<PhotoFacts> {
        let views = self.model.views();
        let turns: Vec<Option<Turn>> = views.iter().map(|view| Turn::of(view.camera.pose())).collect();
        let facts = views.iter().enumerate().map(|(place, view)| {
            let (turn, yaw_deg) = (turns[place], view.camera.pose().yaw_deg);
            let adds = place == 0 || (turn.is_some() && !turns[..place].contains(&turn));
            (view.photo, PhotoFacts { leads: place == 0, yaw_deg, turn, adds })
        });
        let mut facts: Vec<_> = facts.collect();
        facts.sort_by_key(|(photo, _)| *photo);
        facts.into_iter().map(|(_, facts)| facts).collect()
    }

    /// The turns of the head that none of them shows.
    pub fn missing_turns(&self) -> Vec<Turn> {
        Turn::missing(self.model.views().iter().map(|view| view.camera.pose()))
    }

    /// The face as a further photo has it, too; the edits are carried out again. Tells whether another one leads now.
    pub(crate) fn add_photo(&mut self, photo: &FurtherPhoto, choices: &Choices) -> Result<bool, SessionError> {
        self.see_in(self.model.with_photo(photo.input())?, choices)
    }

    /// The face as the other photos have it; the edits are carried out again. Tells whether another one leads now.
    pub(crate) fn remove_photo(&mut self, photo: usize, choices: &Choices) -> Result<bool, SessionError> {
        let count = self.model.views().len();
        if photo >= count {
            return Err(SessionError::NoSuchPhoto { photo, count });
        }
        self.see_in(self.model.without_photo(photo)?, choices)
    }

    fn see_in(&mut self, model: FaceModel, choices: &Choices) -> Result<bool, SessionError> {
        let is_another = model.landmarks() != self.model.landmarks();
        let led = self.model.landmarks().to_vec();
        self.see_as(model, choices)?;
        if is_another {
            // What was kept of one photo, and how it was seen, says nothing about another, but is there when that one leads again.
            let next = PhotoEdit::of_next_photo(&self.photo);
            let before = std::mem::replace(&mut self.photo, next);
            self.set_aside.push((led, before.seen_from_m, before.strokes));
            let leads = self.model.landmarks();
            if let Some(place) = self.set_aside.iter().position(|(landmarks, ..)| *landmarks == leads) {
                let (_, seen_from_m, strokes) = self.set_aside.swap_remove(place);
                self.restore_photo(seen_from_m, strokes);
            }
        }
        Ok(is_another)
    }
}
