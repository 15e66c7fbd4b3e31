use rosto_face::{CardCorners, FaceModel, Observation, PhotoLens, Turn};

use super::{OpenFace, PhotoEdit};
use crate::edit_options::EditOptions;
use crate::error::SessionError;

/// A photo of a face, for display.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhotoFacts {
    /// Whether it is the lead photo: its colours, size and lens are the face's, and it is the displayed one.
    pub leads: bool,
    /// Yaw of the head in degrees; positive to the subject's left.
    pub yaw_deg: f64,
    /// The recommended turn of the head that it shows, if it shows one.
    pub turn: Option<Turn>,
    /// Whether it shows a turn that neither the lead photo nor an earlier one shows.
    pub adds: bool,
}

/// The photos of the face.
impl OpenFace {
    /// The photos, in the order in which they were added.
    pub fn photos(&self) -> Vec<PhotoFacts> {
        let views = self.model.views();
        let turns: Vec<Option<Turn>> = views.iter().map(|view| Turn::of(view.camera.pose())).collect();
        let facts = |index: usize| {
            let (turn, yaw_deg) = (turns[index], views[index].camera.pose().yaw_deg);
            let adds = index == 0 || (turn.is_some() && !turns[..index].contains(&turn));
            PhotoFacts { leads: index == 0, yaw_deg, turn, adds }
        };
        let index_of = |photo| views.iter().position(|view| view.photo == photo);
        (0..views.len()).filter_map(index_of).map(facts).collect()
    }

    /// The recommended turns of the head that no photo shows.
    pub fn missing_turns(&self) -> Vec<Turn> {
        Turn::missing(self.model.views().iter().map(|view| view.camera.pose()))
    }

    /// Index of the lead photo, in the order in which they were added.
    pub fn lead_photo(&self) -> usize {
        self.model.views()[0].photo
    }

    /// Lens by the lead photo's own data, whichever is used.
    pub fn found_lens(&self) -> PhotoLens {
        self.model.views()[0].observation.found_lens
    }

    /// Adds a photo to the model and reapplies the edits. Returns whether the lead photo changed.
    pub(crate) fn add_photo(&mut self, photo: Observation, edit_options: &EditOptions) -> Result<bool, SessionError> {
        self.use_photos(self.model.with_photo(photo)?, edit_options)
    }

    /// Removes a photo from the model and reapplies the edits. Returns whether the lead photo changed.
    pub(crate) fn remove_photo(&mut self, photo: usize, edit_options: &EditOptions) -> Result<bool, SessionError> {
        let count = self.model.views().len();
        if photo >= count {
            return Err(SessionError::NoSuchPhoto { photo, count });
        }
        self.use_photos(self.model.without_photo(photo)?, edit_options)
    }

    /// Changes the lens of the lead photo and reapplies the edits. Returns false, as the lead photo is the same.
    pub(crate) fn set_photo_lens(&mut self, lens: PhotoLens, edit_options: &EditOptions) -> Result<bool, SessionError> {
        self.use_photos(self.model.with_lens(lens)?, edit_options)
    }

    /// Measures the face by a card in the lead photo, or without one, and reapplies the edits. Returns false, as the lead
    /// photo is the same.
    pub(crate) fn set_card(
        &mut self,
        card: Option<CardCorners>,
        edit_options: &EditOptions,
    ) -> Result<bool, SessionError> {
        self.use_photos(self.model.with_card(card)?, edit_options)
    }

    fn use_photos(&mut self, model: FaceModel, edit_options: &EditOptions) -> Result<bool, SessionError> {
        let is_another = model.landmarks() != self.model.landmarks();
        let led = self.model.landmarks().to_vec();
        self.replace_model(model, edit_options)?;
        if is_another {
            // Strokes and view distance belong to one photo; they are restored when that photo leads again.
            let next = PhotoEdit::of_next_photo(&self.photo);
            let before = std::mem::replace(&mut self.photo, next);
            self.inactive_photos.push((led, before.seen_from_m, before.strokes));
            let leads = self.model.landmarks();
            if let Some(index) = self.inactive_photos.iter().position(|(landmarks, ..)| *landmarks == leads) {
                let (_, seen_from_m, strokes) = self.inactive_photos.swap_remove(index);
                self.restore_photo(seen_from_m, strokes);
            }
        }
        Ok(is_another)
    }
}
