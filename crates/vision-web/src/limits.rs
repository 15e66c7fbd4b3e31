use js_sys::Error;
use rosto::{FileKind, Limits, SNIFFED_BYTES, sniff};
use wasm_bindgen::prelude::*;

use crate::error;

/// Largest GLB or project, in bytes. Rosto's are far smaller.
const MAX_SAVED_BYTES: usize = 400_000_000;

/// Checks the length of a file, in bytes, before it is read. Returns whether it is a GLB or project.
///
/// `start`: the first bytes of the file, as many as `sniffedBytes` returns.
///
/// # Errors
/// Throws `too-many-bytes`.
#[wasm_bindgen(js_name = checkFile)]
pub fn check_file(start: &[u8], bytes: f64) -> Result<bool, Error> {
    let is_saved = sniff(start) != FileKind::Other;
    let limits = Limits::default();
    let max_bytes = if is_saved { MAX_SAVED_BYTES } else { limits.max_bytes };
    Limits { max_bytes, ..limits }.check_length(bytes as u64).map_err(error::of_photo)?;
    Ok(is_saved)
}

/// Number of bytes from which [`check_file`] detects the kind of a file.
#[wasm_bindgen(js_name = sniffedBytes)]
pub fn sniffed_bytes() -> usize {
    SNIFFED_BYTES
}

/// Checks a photo's size in px.
///
/// # Errors
/// Throws `too-many-pixels`.
#[wasm_bindgen(js_name = checkSize)]
pub fn check_size(width: u32, height: u32) -> Result<(), Error> {
    Limits::default().check_size(width, height).map_err(error::of_photo)
}
