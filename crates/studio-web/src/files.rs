use rosto::{ExpressionsAs, Eyes, FileOptions, Format};
use rosto_stage::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::error::FacadeError;
use crate::sent::sent;
use crate::snapshot::Snapshot;

/// Facts for files, and pictures of the view.
#[wasm_bindgen]
impl Studio {
    /// Numbers of points and triangles of the mesh in a GLB, for values of the file options "eyes" and "expressions".
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = meshCounts)]
    pub fn mesh_counts(&self, eyes: &str, expressions: &str) -> Result<Vec<u32>, JsValue> {
        let options = FileOptions {
            eyes: FacadeError::require(Eyes::from_id(eyes))?,
            expressions: FacadeError::require(ExpressionsAs::from_id(expressions))?,
            ..FileOptions::default()
        };
        let has_pieces = options.has_pieces(Format::Glb);
        Ok(self.face()?.mesh_counts(has_pieces).map(|count| count as u32).to_vec())
    }

    /// Renders a picture of the view in any size, without marks and tools, optionally with a transparent background.
    ///
    /// # Errors
    /// Throws `device-lost`; the promise rejects with `no-memory` or `not-drawn`.
    #[wasm_bindgen(unchecked_return_type = "Promise<Snapshot>")]
    pub fn snapshot(
        &mut self,
        #[wasm_bindgen(js_name = widthPx)] width_px: u32,
        #[wasm_bindgen(js_name = heightPx)] height_px: u32,
        transparent: bool,
    ) -> Result<js_sys::Promise, JsValue> {
        let background = if transparent { Background::Transparent } else { self.session.view().background };
        let picture = self.viewport.snapshot(&self.session.stage().without_tools(), [width_px, height_px], background);
        self.session.stage_mut().request_frame();
        let picture = picture.map_err(FacadeError::from)?;
        Ok(future_to_promise(async move {
            let snapshot = Snapshot::from(picture.await.map_err(FacadeError::from)?);
            Ok(sent(&snapshot)?.into())
        }))
    }
}
