use glam::DVec2;
use rosto_face::Photo;
use rosto_viewport::ViewportError;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::shown::PanelPhoto;

/// The edited photo on the panel.
#[wasm_bindgen]
impl Studio {
    /// Sets the part of the original photo that the panel shows: RGBA, `width` px wide, with its top left corner at a
    /// position in the upright photo, at `scale` times its size.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = setPanelPhoto)]
    pub fn set_panel_photo(
        &mut self,
        rgba: &[u8],
        width: u32,
        #[wasm_bindgen(js_name = leftPx)] left_px: f64,
        #[wasm_bindgen(js_name = topPx)] top_px: f64,
        scale: f64,
    ) -> Result<(), JsValue> {
        let height = (rgba.len() / 4).checked_div(width as usize).unwrap_or_default() as u32;
        let bad = |_| FacadeError::from(ViewportError::BadPicture { width, height, found: rgba.len() });
        let photo = Photo::from_rgbx(width, height, rgba).map_err(bad)?;
        self.photo_shown.panel = Some(PanelPhoto { photo, corner_px: DVec2::new(left_px, top_px), scale });
        Ok(())
    }

    /// The panel's part of the photo with the edits, RGBA; undefined if nothing moves in it or no part is set.
    #[wasm_bindgen(js_name = panelPhoto)]
    pub fn panel_photo(&self) -> Option<Vec<u8>> {
        let PanelPhoto { photo, corner_px, scale } = self.photo_shown.panel.as_ref()?;
        let (warp_mesh, _) = self.session.face()?.photo().warp_mesh()?;
        Some(rosto_warp::drawn(photo, &warp_mesh.cut(*corner_px, *scale)).rgbx())
    }
}
