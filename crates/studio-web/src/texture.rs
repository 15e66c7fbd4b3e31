use rosto_session::Changed;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;
use crate::picture::IncomingPicture;

/// The texture of the whole face: the worker makes it, which takes longer than a frame, and it comes back as rows of pixels.
#[wasm_bindgen]
impl Studio {
    /// How long the side of the open face's texture is, or is to be, in px; undefined without a face.
    #[wasm_bindgen(getter, js_name = textureSidePx)]
    pub fn texture_side_px(&self) -> Option<u32> {
        self.session.texture_side_px()
    }

    /// How long the side of a texture is to be, in px, that the open face lacks; undefined where it lacks none.
    #[wasm_bindgen(getter, js_name = textureWantedPx)]
    pub fn texture_wanted_px(&self) -> Option<u32> {
        self.session.texture_wanted_px()
    }

    /// What it is made of but for the pixels of the photo, as the worker's `TextureMaker` takes it.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = texturePlan)]
    pub fn texture_plan(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.session.texture_plan().map_err(FacadeError::from)?)
    }

    /// Makes room for a texture of `side` × `side` px, whose rows are to follow. The one that is there stays until it is whole.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openTexture)]
    pub fn open_texture(&mut self, side: u32) -> Result<(), JsValue> {
        self.incoming_texture = None;
        self.incoming_texture = Some(IncomingPicture::new(&self.viewport, side, side)?);
        Ok(())
    }

    /// Takes the next rows of it, RGBA, and shows it once it is whole. One that is not wanted any more is passed over.
    ///
    /// # Errors
    /// `bad-face` for a part of a row or more rows than there are; the texture is then to be opened anew.
    #[wasm_bindgen(js_name = addTextureRows)]
    pub fn add_texture_rows(&mut self, rgba: &[u8]) -> Result<ChangeName, JsValue> {
        let incoming = self.incoming_texture.take().ok_or_else(FacadeError::no_picture)?;
        match incoming.add(&self.viewport, rgba)? {
            Ok(whole) => {
                let changed = self.session.take_texture(whole.photo.clone());
                if changed != Changed::Nothing {
                    self.texture = Some(whole);
                }
                self.show_soon(changed);
                // It comes by itself, as time does: panels, and what is being typed in them, stay as they are.
                Ok(changed.min(Changed::View).into())
            }
            Err(part) => {
                self.incoming_texture = Some(part);
                Ok(Changed::Nothing.into())
            }
        }
    }
}
