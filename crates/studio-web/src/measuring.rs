use rosto_face::{Measure, PhotoLens};
use rosto_session::Intent;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;

/// How the photo was taken, and how large the face is.
#[wasm_bindgen]
impl Studio {
    /// What is known of the open face beside its mesh, as the text of a JSON object: how its photo was taken, how the head is
    /// turned, and the usual measures of its shape as it is edited.
    ///
    /// # Errors
    /// `no-face`.
    pub fn about(&self) -> Result<String, JsValue> {
        Ok(self.face()?.about_json())
    }

    /// The ids of the usual measures, in the order in which they are shown.
    #[wasm_bindgen(getter, js_name = measureIds)]
    pub fn measure_ids(&self) -> Vec<String> {
        Measure::ALL.map(|measure| measure.id().to_owned()).to_vec()
    }

    /// What is taken to be known of the photo's lens; undefined while no face is open.
    #[wasm_bindgen(getter, js_name = photoLens)]
    pub fn photo_lens(&self) -> Option<String> {
        self.session.face().map(|face| face.model().lens().to_string())
    }

    /// Takes the photo as taken through another lens: `estimated`, `exif:MM`, `given:MM` or `distance:M`. The model follows,
    /// with its edits.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = setPhotoLens)]
    pub fn set_photo_lens(&mut self, lens: &str) -> Result<ChangeName, JsValue> {
        let lens: Option<PhotoLens> = lens.parse().ok();
        self.act(Intent::PhotoLens(FacadeError::unless(lens)?))
    }

    /// From one vertex to another in mm: straight, and along the surface.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    pub fn measure(&self, from: u32, to: u32) -> Result<Vec<f64>, JsValue> {
        Ok(self.face()?.measured_mm(from, to).map_err(FacadeError::from)?.to_vec())
    }
}
