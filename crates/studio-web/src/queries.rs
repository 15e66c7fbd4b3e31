use glam::DVec2;
use rosto_face::LANDMARK_COUNT;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;

/// Positions on the canvas, in device pixels from its top left, and measures.
#[wasm_bindgen]
impl Studio {
    /// Position of a vertex on the canvas: x, y; undefined without a face.
    #[wasm_bindgen(js_name = screenPosition)]
    pub fn screen_position(&self, vertex: u32) -> Option<Vec<f64>> {
        let position_m = *self.session.face()?.document().positions().get(vertex as usize)?;
        Some(self.session.stage().camera().project(position_m)?.to_array().to_vec())
    }

    /// Bounding box of the landmarks on the canvas: left, top, right, bottom; empty without a face.
    #[wasm_bindgen(js_name = screenBox)]
    pub fn screen_box(&self) -> Vec<f64> {
        let Some(face) = self.session.face() else { return Vec::new() };
        let camera = self.session.stage().camera();
        let landmarks = face.document().positions().iter().take(LANDMARK_COUNT);
        let positions = landmarks.filter_map(|&position_m| camera.project(position_m));
        let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (from, to) = positions.fold(empty, |(from, to), position| (from.min(position), to.max(position)));
        vec![from.x, from.y, to.x, to.y]
    }

    /// Opacity of the marks at the selection, 0..1; they fade one second after their last use.
    #[wasm_bindgen(getter, js_name = toolsOpacity)]
    pub fn tools_opacity(&self) -> f64 {
        self.session.stage().tools_opacity()
    }

    /// Data of the open face apart from its mesh, as JSON text: its photo's lens, the pose of the head, and the
    /// measures of its edited shape.
    ///
    /// # Errors
    /// `no-face`.
    pub fn about(&self) -> Result<String, JsValue> {
        Ok(self.face()?.about_json())
    }

    /// Distance between two vertices in mm: straight, and along the surface.
    ///
    /// # Errors
    /// `no-face` or `bad-vertex`.
    pub fn measure(&self, from: u32, to: u32) -> Result<Vec<f64>, JsValue> {
        Ok(self.face()?.measured_mm(from, to).map_err(FacadeError::from)?.to_vec())
    }
}
