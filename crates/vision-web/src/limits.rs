use js_sys::Error;
use rosto_photo::Limits;
use wasm_bindgen::prelude::*;

use crate::error;

/// Checks a photo's file size in bytes before it is read.
///
/// # Errors
/// Throws `too-many-bytes`.
#[wasm_bindgen(js_name = checkLength)]
pub fn check_length(bytes: f64) -> Result<(), Error> {
    Limits::default().check_length(bytes as u64).map_err(error::of_photo)
}

/// Checks a photo's size in px.
///
/// # Errors
/// Throws `too-many-pixels`.
#[wasm_bindgen(js_name = checkSize)]
pub fn check_size(width: u32, height: u32) -> Result<(), Error> {
    Limits::default().check_size(width, height).map_err(error::of_photo)
}
