use rosto_studio::FaceSlider;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::trouble::Trouble;

/// Changes of the whole face: ready-made sliders and symmetry.
#[wasm_bindgen]
impl Studio {
    /// One tick of a ready-made slider: `toMm` is where it is to stand, its earlier entries counted. The first tick takes
    /// it in hand (one solve); `commit` and `cancel` end it, after which the selection is in hand again.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `bad-number`.
    pub fn slide(&mut self, slider: &str, #[wasm_bindgen(js_name = toMm)] to_mm: f64) -> Result<(), JsValue> {
        let slider = FaceSlider::from_id(slider).ok_or_else(Trouble::bad_choice)?;
        if self.session()?.slider() != Some(slider) {
            self.drag = None;
            self.change(|session, choices| session.take_slider(slider, choices))?;
        }
        self.session_mut()?.0.slide(slider, to_mm)?;
        Ok(self.show_offset()?)
    }

    /// Brings the two sides of the face closer to each other: 100 per cent leaves mirror images.
    ///
    /// # Errors
    /// `no-face` or `cannot-solve`.
    pub fn symmetrise(&mut self, #[wasm_bindgen(js_name = perCent)] per_cent: f64) -> Result<(), JsValue> {
        self.change(|session, choices| session.symmetrise(per_cent / 100.0, choices))
    }
}
