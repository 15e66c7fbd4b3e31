use std::io::Cursor;

use image::codecs::{jpeg::JpegDecoder, png::PngDecoder, webp::WebPDecoder};
use image::{ImageDecoder, ImageError};

use crate::format::Format;
use crate::icc::Conversion;
use crate::{Limits, Photo, PhotoError, jpeg, orientation, pixels};

/// Decodes a JPEG, PNG or WebP file to an upright picture. Of an animation, the first frame.
///
/// # Errors
/// [`PhotoError`], each with what it found. Sizes are refused before the pixels are allocated.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    limits.check_bytes(bytes)?;
    let format = Format::sniff(bytes)?;
    match format {
        Format::Jpeg => decode_jpeg(bytes, limits),
        Format::Png => decode_png(bytes, limits),
        Format::WebP => {
            let decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(|error| refused(format, error))?;
            finish(decoder, format, limits)
        }
    }
}

fn decode_jpeg(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    let format = Format::Jpeg;
    let decoder = JpegDecoder::new(Cursor::new(bytes)).map_err(|error| refused(format, error))?;
    let (width, height) = decoder.dimensions();
    limits.check_size(width, height)?;
    if !jpeg::reaches_its_end(bytes) {
        return Err(damaged(format, "it ends before its last row".to_owned()));
    }
    finish(decoder, format, limits)
}

fn decode_png(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    /// Room for metadata, a colour profile above all, which is stored compressed.
    const METADATA_BYTES: u64 = 16_000_000;
    let format = Format::Png;
    // Read here, because the decoder wants to see pixel data before it tells the size.
    if let Some((width, height)) = png_size(bytes) {
        limits.check_size(width, height)?;
    }
    let mut decoder_limits = image::Limits::no_limits();
    decoder_limits.max_alloc = Some(limits.max_pixels.saturating_mul(8).saturating_add(METADATA_BYTES));
    let decoder =
        PngDecoder::with_limits(Cursor::new(bytes), decoder_limits).map_err(|error| refused(format, error))?;
    finish(decoder, format, limits)
}

/// Width and height out of the header chunk, which the format wants first.
fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.get(12..24)?.strip_prefix(b"IHDR")?;
    let number = |at: usize| u32::from_be_bytes([header[at], header[at + 1], header[at + 2], header[at + 3]]);
    Some((number(0), number(4)))
}

fn finish(mut decoder: impl ImageDecoder, format: Format, limits: &Limits) -> Result<Photo, PhotoError> {
    let (width, height) = decoder.dimensions();
    limits.check_size(width, height)?;
    // Broken metadata is no reason to refuse the picture.
    let exif = decoder.exif_metadata().ok().flatten().unwrap_or_default();
    let profile = decoder.icc_profile().ok().flatten().unwrap_or_default();
    let layout = decoder.color_type();
    let mut decoded = vec![0; width as usize * height as usize * usize::from(layout.bytes_per_pixel())];
    decoder.read_image(&mut decoded).map_err(|error| refused(format, error))?;
    let mut rgb = pixels::to_rgb(decoded, layout).ok_or_else(|| PhotoError::UnsupportedFeature {
        format: format.name(),
        reason: format!("{layout:?} pixels"),
    })?;
    if let Some(conversion) = Conversion::from_profile(&profile) {
        conversion.apply(&mut rgb);
    }
    Ok(orientation::apply(Photo::from_rgb(width, height, rgb)?, orientation::from_exif(&exif)))
}

fn refused(format: Format, error: ImageError) -> PhotoError {
    match error {
        ImageError::Unsupported(error) => {
            PhotoError::UnsupportedFeature { format: format.name(), reason: error.to_string() }
        }
        error => damaged(format, error.to_string()),
    }
}

fn damaged(format: Format, reason: String) -> PhotoError {
    PhotoError::Damaged { format: format.name(), reason }
}
