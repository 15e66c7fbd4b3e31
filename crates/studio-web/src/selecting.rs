use glam::DVec2;
use rosto_face::Region;
use rosto_session::{Intent, Selection};
use rosto_studio::Switch;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;

/// Selecting landmarks, regions and points, and pinning them. Places are device pixels from the canvas' top left.
#[wasm_bindgen]
impl Studio {
    /// Selects a landmark, or nothing. Random anchors are drawn anew.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    pub fn select(&mut self, vertex: Option<u32>) -> Result<ChangeName, JsValue> {
        self.act(Intent::Select(vertex.map(Selection::Landmark)))
    }

    /// Selects all landmarks of a region, by the region's id; they move as one.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = selectRegion)]
    pub fn select_region(&mut self, region: &str) -> Result<ChangeName, JsValue> {
        let region = FacadeError::unless(Region::from_id(region))?;
        self.act(Intent::Select(Some(Selection::Region(region))))
    }

    /// Selects what is at a vertex: it alone, or the smallest region around it and, asked again, the next larger one.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    #[wasm_bindgen(js_name = selectAt)]
    pub fn select_at(&mut self, vertex: u32) -> Result<ChangeName, JsValue> {
        self.act(Intent::SelectAt(vertex))
    }

    /// The same at a place on the canvas; nothing is selected where there is no face.
    #[wasm_bindgen(js_name = selectUnder)]
    pub fn select_under(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::SelectUnder(DVec2::new(x_px, y_px)))
    }

    /// Pins what is selected, so that it stays while others move, or frees it.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    #[wasm_bindgen(js_name = setPinned)]
    pub fn set_pinned(&mut self, pinned: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Pin(if pinned { Switch::On } else { Switch::Off }))
    }

    /// Pins the vertex at a place on the canvas, or frees it.
    #[wasm_bindgen(js_name = pinUnder)]
    pub fn pin_under(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::PinUnder(DVec2::new(x_px, y_px)))
    }
}
