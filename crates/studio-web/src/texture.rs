use rosto_session::Changed;
use rosto_studio::texture_side_px;
use tsify::Ts;
use wasm_bindgen::prelude::*;
use web_sys::ImageBitmap;

use crate::Studio;
use crate::picture::OpenPicture;
use crate::sent::sent;

/// The whole-face texture. The worker bakes it, which takes longer than a frame.
#[wasm_bindgen]
impl Studio {
    /// Number of the texture that the open face needs; undefined if it is shown. It changes with the photos, their
    /// lenses and the selected size.
    #[wasm_bindgen(js_name = textureWanted)]
    pub fn texture_wanted(&self) -> Option<u32> {
        self.session.texture_wanted()
    }

    /// Shows a texture, the result of the worker's `texture` at the time of a request, and closes the bitmap when it
    /// is replaced. An outdated texture is ignored.
    ///
    /// # Errors
    /// `bad-face` if the bitmap is closed or too large.
    #[wasm_bindgen(js_name = setTexture)]
    pub fn set_texture(&mut self, request: u32, bitmap: ImageBitmap) -> Result<Ts<Changed>, JsValue> {
        if self.session.texture_wanted() != Some(request) {
            bitmap.close();
            return Ok(sent(&Changed::Nothing)?);
        }
        self.pictures.texture = Some(OpenPicture::new(bitmap, &self.viewport)?);
        let changed = self.session.take_texture(request);
        self.show_soon(changed);
        // The texture is not a user action: panels and their inputs stay as they are.
        Ok(sent(&changed.min(Changed::View))?)
    }
}

impl Studio {
    /// Side in px of the open face's texture at the selected size; none without a face.
    pub(crate) fn texture_side_px(&self) -> Option<u32> {
        let (face, at_most_px) = (self.session.face()?, self.session.view().texture_size.px());
        Some(texture_side_px(face.model(), |view| self.pictures.size_px(view.photo), at_most_px))
    }
}
