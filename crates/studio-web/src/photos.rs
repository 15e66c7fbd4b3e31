use rosto_face::Turn;
use rosto_session::{FurtherPhoto, Intent, PhotoFacts};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::modes::ChangeName;
use crate::picture::OpenPicture;
use crate::readable::readable;

readable! {
    /// A photo of the open face.
    pub struct StudioPhoto {
        /// Whether it is the lead photo: its colours, size and lens are the face's, and it is the displayed one.
        leads: bool,
        /// Yaw of the head in degrees; positive to the subject's left.
        yaw_deg as yawDeg: f64,
        /// "front", "left" or "right"; undefined for other angles.
        turn: Option<String>,
        /// Whether it shows a turn that neither the lead photo nor an earlier one shows.
        adds: bool,
    }
}

impl From<PhotoFacts> for StudioPhoto {
    fn from(facts: PhotoFacts) -> Self {
        let turn = facts.turn.map(|turn| turn.id().to_owned());
        Self { leads: facts.leads, yaw_deg: facts.yaw_deg, turn, adds: facts.adds }
    }
}

/// Several photos of one face.
#[wasm_bindgen]
impl Studio {
    /// Adds the last opened picture, with its detection as for `openFace`, to the photos of the next face. The next
    /// picture is a further photo of that face. The photos keep this order.
    ///
    /// # Errors
    /// `bad-face` or `bad-choice`.
    #[wasm_bindgen(js_name = keepPhoto)]
    pub fn keep_photo(
        &mut self,
        landmarks: &[f32],
        width: u32,
        height: u32,
        colours: &[u8],
        lens: &str,
    ) -> Result<(), JsValue> {
        let photo = self.detected_photo(landmarks, [width, height], colours, lens)?;
        self.next_photos.push(photo);
        Ok(())
    }

    /// Adds the last opened picture to the open face as a further photo; the edits are reapplied.
    ///
    /// # Errors
    /// `bad-face`, `another-face`, `too-many-photos` or `bad-choice`.
    #[wasm_bindgen(js_name = addPhoto)]
    pub fn add_photo(
        &mut self,
        landmarks: &[f32],
        width: u32,
        height: u32,
        colours: &[u8],
        lens: &str,
    ) -> Result<ChangeName, JsValue> {
        let (photo, picture) = self.detected_photo(landmarks, [width, height], colours, lens)?;
        Ok(self.change_photos(Intent::AddPhoto(Box::new(photo)), Some(picture))?)
    }

    /// Removes a photo of the open face, by its index in `photos`; the edits are reapplied.
    ///
    /// # Errors
    /// `bad-number` if it does not exist, `too-many-photos` if it is the only one.
    #[wasm_bindgen(js_name = removePhoto)]
    pub fn remove_photo(&mut self, photo: u32) -> Result<ChangeName, JsValue> {
        Ok(self.change_photos(Intent::RemovePhoto(photo as usize), None)?)
    }

    /// The photos of the open face, in the order in which they were added.
    pub fn photos(&self) -> Vec<StudioPhoto> {
        let face = self.session.face();
        face.map(|face| face.photos().into_iter().map(StudioPhoto::from).collect()).unwrap_or_default()
    }

    /// Maximum number of photos of one face.
    #[wasm_bindgen(getter, js_name = maxPhotos)]
    pub fn max_photos(&self) -> u32 {
        rosto_face::MAX_PHOTOS as u32
    }

    /// The turns of the head that no photo shows: of "front", "left" and "right".
    #[wasm_bindgen(js_name = missingTurns)]
    pub fn missing_turns(&self) -> Vec<String> {
        let missing = self.session.face().map(rosto_session::OpenFace::missing_turns).unwrap_or_default();
        missing.into_iter().map(|turn: Turn| turn.id().to_owned()).collect()
    }
}

impl Studio {
    /// The last opened picture with its detection.
    pub(crate) fn detected_photo(
        &self,
        landmarks: &[f32],
        photo_size_px: [u32; 2],
        colours: &[u8],
        lens: &str,
    ) -> Result<(FurtherPhoto, OpenPicture)> {
        let picture = self.next_picture.clone().ok_or_else(FacadeError::no_picture)?;
        let photo = FurtherPhoto {
            landmarks: landmarks.as_chunks::<3>().0.to_vec(),
            photo_size_px,
            colours_srgb: colours.as_chunks::<3>().0.to_vec(),
            picture: picture.photo.clone(),
            lens: FacadeError::require(lens.parse().ok())?,
        };
        Ok((photo, picture))
    }

    fn change_photos(&mut self, intent: Intent, added: Option<OpenPicture>) -> Result<ChangeName> {
        let changed = self.session.apply(intent)?;
        // If the upload fails, the next frame uploads everything again.
        match self.show_lead(added) {
            Ok(()) => self.show_soon(changed),
            Err(_) => self.show_later(),
        }
        Ok(changed.into())
    }

    /// Uploads the lead photo if it has changed.
    pub(crate) fn show_lead(&mut self, added: Option<OpenPicture>) -> Result<()> {
        let Some(face) = self.session.face() else { return Ok(()) };
        let lead = face.model().picture();
        let is_lead = |picture: &OpenPicture| std::ptr::eq(picture.photo.pixels(), lead.pixels());
        if self.picture.as_ref().is_some_and(is_lead) {
            return Ok(());
        }
        self.picture = Some(match added.filter(is_lead) {
            Some(added) => added,
            None => OpenPicture::of(lead.clone(), &self.viewport)?,
        });
        Ok(())
    }
}
