use std::io::Cursor;

use image::codecs::webp::WebPDecoder;
use image::{ImageDecoder, ImageError};

use crate::format::Format;
use crate::stored::Stored;
use crate::{Limits, Photo, PhotoError, icc, jpeg, pixels, png, webp};

/// Decodes a JPEG, PNG or WebP file to an upright picture; of an animation, the first frame.
///
/// # Errors
/// [`PhotoError`] if the file is unsupported, damaged or over a limit. Sizes are checked before the pixels are
/// allocated.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    limits.check_length(bytes.len() as u64)?;
    match Format::sniff(bytes)? {
        Format::Jpeg => jpeg::decode(bytes, limits),
        Format::Png => png::decode(bytes, limits),
        Format::WebP => decode_webp(bytes, limits),
    }
}

fn decode_webp(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    webp::check_chunks(bytes)?;
    let mut decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(decode_error)?;
    let (width, height) = decoder.dimensions();
    limits.check_size(width, height)?;
    // Damaged metadata is ignored; the pixels are still valid.
    let exif = decoder.exif_metadata().ok().flatten().unwrap_or_default();
    let profile = decoder.icc_profile().ok().flatten().unwrap_or_default();
    let layout = decoder.color_type();
    let mut decoded = vec![0; width as usize * height as usize * usize::from(layout.bytes_per_pixel())];
    decoder.read_image(&mut decoded).map_err(decode_error)?;
    let unsupported = || Format::WebP.unsupported(format!("{layout:?} pixels"));
    let (rgb, alpha) = pixels::to_rgb(decoded, layout).ok_or_else(unsupported)?;
    let colours = icc::encoding(&profile, layout);
    Stored { width, height, rgb, alpha, colours, exif }.upright()
}

fn decode_error(error: ImageError) -> PhotoError {
    match error {
        ImageError::Unsupported(error) => Format::WebP.unsupported(error),
        error => Format::WebP.damaged(error),
    }
}
