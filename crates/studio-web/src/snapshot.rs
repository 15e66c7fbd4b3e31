use wasm_bindgen::prelude::*;

use crate::readable::readable;

readable! {
    /// A picture of the canvas as straight (not premultiplied) sRGB RGBA.
    pub struct Snapshot {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    } hidden {
        pixels: Vec<u8>,
    }
}

impl From<rosto_viewport::Snapshot> for Snapshot {
    fn from(snapshot: rosto_viewport::Snapshot) -> Self {
        Self { width: snapshot.width, height: snapshot.height, pixels: snapshot.rgba }
    }
}

#[wasm_bindgen]
impl Snapshot {
    /// Takes the pixels, row by row from the top; empty on later calls.
    #[wasm_bindgen(js_name = takePixels)]
    pub fn take_pixels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.pixels)
    }
}
