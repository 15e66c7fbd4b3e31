use js_sys::Uint8ClampedArray;
use serde::Serialize;
use tsify::Tsify;

/// A picture of the canvas.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct Snapshot {
    /// Width in px.
    pub width: u32,
    /// Height in px.
    pub height: u32,
    /// sRGB and straight alpha as RGBA, row by row from the top.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8ClampedArray<ArrayBuffer>")]
    pub rgba: Uint8ClampedArray,
}

impl From<rosto_viewport::Snapshot> for Snapshot {
    fn from(rosto_viewport::Snapshot { width, height, rgba }: rosto_viewport::Snapshot) -> Self {
        Self { width, height, rgba: rgba.as_slice().into() }
    }
}
