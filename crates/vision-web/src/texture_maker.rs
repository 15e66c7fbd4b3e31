use js_sys::Error;
use rosto_photo::Photo;
use rosto_texture::Plan;
use wasm_bindgen::prelude::*;

use crate::error;

/// Bakes the whole-face texture. Call `free()` afterwards.
#[wasm_bindgen]
pub struct TextureMaker {
    plan: Plan,
    pictures: Vec<Photo>,
}

#[wasm_bindgen]
impl TextureMaker {
    /// Creates a texture maker from a plan, the result of the page's `texturePlan`.
    ///
    /// # Errors
    /// Throws `internal` if the plan is invalid.
    #[wasm_bindgen(constructor)]
    pub fn new(plan: &[u8]) -> Result<Self, Error> {
        console_error_panic_hook::set_once();
        let plan = Plan::from_bytes(plan).ok_or_else(|| error::internal("invalid texture plan"))?;
        Ok(Self { plan, pictures: Vec::new() })
    }

    /// Adds the plan's next photo as an upright RGBA picture; alpha is ignored.
    ///
    /// # Errors
    /// Throws `damaged-picture` if the number of pixels is wrong.
    #[wasm_bindgen(js_name = addPicture)]
    pub fn add_picture(&mut self, width: u32, height: u32, rgba: &[u8]) -> Result<(), Error> {
        self.pictures.push(Photo::from_rgbx(width, height, rgba).map_err(error::of_photo)?);
        Ok(())
    }

    /// Bakes the texture, `side` × `side` px, RGBA.
    ///
    /// # Errors
    /// Throws `internal` if the numbers of pictures and photos differ or `side` is invalid.
    pub fn make(&self, side: u32) -> Result<Vec<u8>, Error> {
        let pictures: Vec<&Photo> = self.pictures.iter().collect();
        let texture = self.plan.texture(&pictures, side).map_err(|reason| error::internal(&reason.to_string()))?;
        Ok(texture.picture.rgba())
    }
}
