use rosto_face::Turn;
use rosto_session::{FurtherPhoto, Intent, PhotoFacts};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::modes::ChangeName;
use crate::picture::OpenPicture;
use crate::readable::readable;

readable! {
    /// One of the photos of the open face.
    pub struct StudioPhoto {
        /// Whether it leads: its colours, size and lens are the face's, and it is the one that is shown.
        leads: bool,
        /// How far the head is turned in it, in degrees: above 0 to the subject's own left.
        yaw_deg as yawDeg: f64,
        /// "front", "left" or "right"; undefined in between and beyond.
        turn: Option<String>,
        /// Whether no other photo shows the face from there.
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
    /// Takes the picture that was opened last for a photo of the face to be opened next, with what was found in it as `openFace`
    /// takes it; the next picture is of a further photo of that face. They keep this order.
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
        let photo = self.photo_found(landmarks, [width, height], colours, lens)?;
        self.next_photos.push(photo);
        Ok(())
    }

    /// Takes it for a further photo of the open face, whose edits stay.
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
        let (photo, picture) = self.photo_found(landmarks, [width, height], colours, lens)?;
        Ok(self.change_photos(Intent::AddPhoto(Box::new(photo)), Some(picture))?)
    }

    /// Takes one of the photos away from the open face, by its place in `photos`. The edits stay.
    ///
    /// # Errors
    /// `bad-number` for one that is not there, `too-many-photos` for the only one.
    #[wasm_bindgen(js_name = removePhoto)]
    pub fn remove_photo(&mut self, photo: u32) -> Result<ChangeName, JsValue> {
        Ok(self.change_photos(Intent::RemovePhoto(photo as usize), None)?)
    }

    /// The photos of the open face in the order that they were given in.
    pub fn photos(&self) -> Vec<StudioPhoto> {
        let face = self.session.face();
        face.map(|face| face.photos().into_iter().map(StudioPhoto::from).collect()).unwrap_or_default()
    }

    /// As many photos of one face are read together at most.
    #[wasm_bindgen(getter, js_name = mostPhotos)]
    pub fn most_photos(&self) -> u32 {
        rosto_face::MAX_PHOTOS as u32
    }

    /// The turns of the head that none of them shows: of "front", "left" and "right".
    #[wasm_bindgen(js_name = missingTurns)]
    pub fn missing_turns(&self) -> Vec<String> {
        let missing = self.session.face().map(rosto_session::OpenFace::missing_turns).unwrap_or_default();
        missing.into_iter().map(|turn: Turn| turn.id().to_owned()).collect()
    }
}

impl Studio {
    /// The picture that was opened last, with what was found in it.
    pub(crate) fn photo_found(
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
            lens: FacadeError::unless(lens.parse().ok())?,
        };
        Ok((photo, picture))
    }

    fn change_photos(&mut self, intent: Intent, added: Option<OpenPicture>) -> Result<ChangeName> {
        let changed = self.session.apply(intent)?;
        // One that cannot be brought to the GPU now is, with all else, before the next frame.
        match self.show_lead(added) {
            Ok(()) => self.show_soon(changed),
            Err(_) => self.show_later(),
        }
        Ok(changed.into())
    }

    /// The photo that leads is the one on the GPU.
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
