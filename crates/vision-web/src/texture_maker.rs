use js_sys::Error;
use rosto_photo::Photo;
use rosto_texture::Plan;
use wasm_bindgen::prelude::*;

use crate::error;

/// Makes the texture of a whole face. `free()` it when it is made.
#[wasm_bindgen]
pub struct TextureMaker {
    plan: Plan,
    pictures: Vec<Photo>,
}

#[wasm_bindgen]
impl TextureMaker {
    /// By a plan, as the page's `texturePlan` gives it.
    ///
    /// # Errors
    /// Throws `internal` for anything else.
    #[wasm_bindgen(constructor)]
    pub fn new(plan: &[u8]) -> Result<Self, Error> {
        console_error_panic_hook::set_once();
        let plan = Plan::from_bytes(plan).ok_or_else(|| error::internal("no plan of a texture"))?;
        Ok(Self { plan, pictures: Vec::new() })
    }

    /// Adds the next photo of the plan: its upright picture, RGBA, whose alpha is left out.
    ///
    /// # Errors
    /// Throws `damaged-picture` for another number of pixels.
    #[wasm_bindgen(js_name = addPicture)]
    pub fn add_picture(&mut self, width: u32, height: u32, rgba: &[u8]) -> Result<(), Error> {
        self.pictures.push(Photo::from_rgbx(width, height, rgba).map_err(error::of_photo)?);
        Ok(())
    }

    /// The texture, `side` × `side` px, RGBA.
    ///
    /// # Errors
    /// Throws `internal` where there is not one picture for each photo of the plan, or no such side.
    pub fn make(&self, side: u32) -> Result<Vec<u8>, Error> {
        let pictures: Vec<&Photo> = self.pictures.iter().collect();
        let texture = self.plan.texture(&pictures, side).map_err(|reason| error::internal(&reason.to_string()))?;
        Ok(texture.picture.rgba())
    }
}
