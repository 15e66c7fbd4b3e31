use glam::DVec2;
use rosto_face::Region;
use rosto_session::{Intent, Selection};
use rosto_studio::Switch;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;

/// Selecting and pinning. Positions are in device pixels from the top left of the canvas.
#[wasm_bindgen]
impl Studio {
    /// Selects a landmark, or clears the selection. Random anchors are drawn again.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    pub fn select(&mut self, vertex: Option<u32>) -> Result<ChangeName, JsValue> {
        self.act(Intent::Select(vertex.map(Selection::Landmark)))
    }

    /// Selects the landmarks of a region, which then move together.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = selectRegion)]
    pub fn select_region(&mut self, region: &str) -> Result<ChangeName, JsValue> {
        let region = FacadeError::require(Region::from_id(region))?;
        self.act(Intent::Select(Some(Selection::Region(region))))
    }

    /// Selects the vertex, or the smallest region around it; repeating selects the next larger region.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    #[wasm_bindgen(js_name = selectAt)]
    pub fn select_at(&mut self, vertex: u32) -> Result<ChangeName, JsValue> {
        self.act(Intent::SelectAt(vertex))
    }

    /// Selects at a position on the canvas; clears the selection outside the face.
    #[wasm_bindgen(js_name = selectUnder)]
    pub fn select_under(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::SelectUnder(DVec2::new(x_px, y_px)))
    }

    /// Pins or unpins the selection. Pins stay in place while other vertices move.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    #[wasm_bindgen(js_name = setPinned)]
    pub fn set_pinned(&mut self, pinned: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Pin(if pinned { Switch::On } else { Switch::Off }))
    }

    /// Pins or unpins the vertex at a position on the canvas.
    #[wasm_bindgen(js_name = pinUnder)]
    pub fn pin_under(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::PinUnder(DVec2::new(x_px, y_px)))
    }
}
