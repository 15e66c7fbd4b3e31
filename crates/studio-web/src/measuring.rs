use rosto_face::{Measure, PhotoLens};
use rosto_session::Intent;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;

/// The photo's lens and the face's measures.
#[wasm_bindgen]
impl Studio {
    /// Data of the open face apart from its mesh, as JSON text: its photo's lens, the pose of the head, and the
    /// measures of its edited shape.
    ///
    /// # Errors
    /// `no-face`.
    pub fn about(&self) -> Result<String, JsValue> {
        Ok(self.face()?.about_json())
    }

    /// Ids of the measures, in display order.
    #[wasm_bindgen(getter, js_name = measureIds)]
    pub fn measure_ids(&self) -> Vec<String> {
        Measure::ALL.map(|measure| measure.id().to_owned()).to_vec()
    }

    /// Lens of the photo; undefined without a face.
    #[wasm_bindgen(getter, js_name = photoLens)]
    pub fn photo_lens(&self) -> Option<String> {
        self.session.face().map(|face| face.model().lens().to_string())
    }

    /// Sets the lens of the photo: `estimated`, `exif:MM`, `given:MM` or `distance:M`. Rebuilds the model and reapplies
    /// the edits.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = setPhotoLens)]
    pub fn set_photo_lens(&mut self, lens: &str) -> Result<ChangeName, JsValue> {
        let lens: Option<PhotoLens> = lens.parse().ok();
        self.act(Intent::PhotoLens(FacadeError::require(lens)?))
    }

    /// Distance between two vertices in mm: straight, and along the surface.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    pub fn measure(&self, from: u32, to: u32) -> Result<Vec<f64>, JsValue> {
        Ok(self.face()?.measured_mm(from, to).map_err(FacadeError::from)?.to_vec())
    }
}
