use rosto_session::Changed;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;
use crate::picture::IncomingPicture;

/// The whole-face texture. The worker bakes it, which takes longer than a frame, and its rows arrive in batches.
#[wasm_bindgen]
impl Studio {
    /// Side of the open face's texture in px; undefined without a face.
    #[wasm_bindgen(getter, js_name = textureSidePx)]
    pub fn texture_side_px(&self) -> Option<u32> {
        self.session.texture_side_px()
    }

    /// Side in px of the texture that the open face needs; undefined if it has it.
    #[wasm_bindgen(getter, js_name = textureWantedPx)]
    pub fn texture_wanted_px(&self) -> Option<u32> {
        self.session.texture_wanted_px()
    }

    /// Plan of the texture for the worker's `TextureMaker`: everything except the pixels of the photos.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = texturePlan)]
    pub fn texture_plan(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.session.texture_plan().map_err(FacadeError::from)?)
    }

    /// Prepares for the rows of a texture of `side` × `side` px. The current texture stays until the new one is
    /// complete.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openTexture)]
    pub fn open_texture(&mut self, side: u32) -> Result<(), JsValue> {
        self.incoming_texture = None;
        self.incoming_texture = Some(IncomingPicture::new(&self.viewport, side, side)?);
        Ok(())
    }

    /// Adds the next rows, RGBA, and shows the texture once it is complete. A texture that is no longer wanted is
    /// ignored.
    ///
    /// # Errors
    /// `bad-face` for partial or surplus rows; open the texture again then.
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
                // The texture is not a user action: panels and their inputs stay as they are.
                Ok(changed.min(Changed::View).into())
            }
            Err(part) => {
                self.incoming_texture = Some(part);
                Ok(Changed::Nothing.into())
            }
        }
    }
}
