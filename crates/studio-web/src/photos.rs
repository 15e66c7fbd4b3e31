use rosto::SavedFace;
use rosto_session::{Changed, Intent};
use tsify::Ts;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::sent::sent;

/// Several photos of one face.
#[wasm_bindgen]
impl Studio {
    /// Adds a photo to the open face: the text of one photo, as of the worker's `open`, and the key of its added
    /// picture, which is dropped if the photo is refused. The edits are reapplied.
    ///
    /// # Errors
    /// `bad-face`, `another-face`, `too-many-photos` or `other-version`.
    #[wasm_bindgen(js_name = addPhoto)]
    pub fn add_photo(&mut self, photos: &str, picture: String) -> Result<Ts<Changed>, JsValue> {
        let added = self.added(photos, &picture);
        match &added {
            Ok(changed) => {
                self.pictures.add_to_face(picture);
                self.show_soon(*changed);
            }
            Err(_) => self.pictures.discard(&picture),
        }
        Ok(sent(&added?)?)
    }

    /// Removes a photo of the open face, by its index in the state's `photos`; the edits are reapplied.
    ///
    /// # Errors
    /// `bad-number` if it does not exist, `too-many-photos` if it is the only one.
    #[wasm_bindgen(js_name = removePhoto)]
    pub fn remove_photo(&mut self, photo: u32) -> Result<Ts<Changed>, JsValue> {
        let photo = photo as usize;
        let changed = self.session.apply(Intent::RemovePhoto(photo)).map_err(FacadeError::from)?;
        self.pictures.remove_from_face(photo);
        self.show_soon(changed);
        Ok(sent(&changed)?)
    }
}

impl Studio {
    fn added(&mut self, photos: &str, picture: &str) -> Result<Changed> {
        let saved = SavedFace::from_json(photos, None).map_err(FacadeError::of_saved)?;
        self.pictures.require(picture)?;
        let [photo] = <[_; 1]>::try_from(saved.photos).map_err(|_| FacadeError::no_picture())?;
        Ok(self.session.apply(Intent::AddPhoto(Box::new(photo)))?)
    }
}
