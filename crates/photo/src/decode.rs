use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Cursor;

use image::codecs::{jpeg::JpegDecoder, webp::WebPDecoder};
use image::{ImageDecoder, ImageError};

use crate::code_points::Told;
use crate::exif::Exif;
use crate::format::Format;
use crate::jpeg::{self, Ending};
use crate::{Limits, Photo, PhotoError, icc, orientation, pixels, png, webp};

/// Decodes a JPEG, PNG or WebP file to an upright picture. Of an animation, the first frame.
///
/// # Errors
/// [`PhotoError`], each with what it found. Sizes are refused before the pixels are allocated.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    limits.check_length(bytes.len() as u64)?;
    let format = Format::sniff(bytes)?;
    match format {
        Format::Jpeg => decode_jpeg(bytes, limits),
        Format::Png => png::decode(bytes, limits),
        Format::WebP => {
            webp::check_chunks(bytes)?;
            let decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(|error| refused(format, error))?;
            finish(decoder, format, limits)
        }
    }
}

fn decode_jpeg(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    let decoder = || JpegDecoder::new(Cursor::new(bytes)).map_err(|error| refused(Format::Jpeg, error));
    let (width, height) = decoder()?.dimensions();
    limits.check_size(width, height)?;
    match jpeg::ending(bytes) {
        Ending::Marked => finish(decoder()?, Format::Jpeg, limits),
        Ending::InLastScan { scanned, restarts } => decode_unmarked(scanned, restarts, limits),
        Ending::TooEarly => Err(without_its_last_row()),
    }
}

/// A JPEG whose last scan may be whole though no marker says so. If it is, then nothing that comes behind it is read;
/// if it is not, whatever comes there shows in the picture.
fn decode_unmarked(scanned: &[u8], restarts: u8, limits: &Limits) -> Result<Photo, PhotoError> {
    let ended_with = |tail: &[u8]| {
        let whole = [scanned, tail, &jpeg::END].concat();
        let decoder = JpegDecoder::new(Cursor::new(&whole)).map_err(|error| refused(Format::Jpeg, error))?;
        finish(decoder, Format::Jpeg, limits)
    };
    let digest = |photo: &Photo| {
        let mut hasher = DefaultHasher::new();
        photo.pixels().hash(&mut hasher);
        hasher.finish()
    };
    let photo = ended_with(&[])?;
    let expected = digest(&photo);
    for tail in jpeg::tails(restarts) {
        if ended_with(&tail).map(|other| digest(&other)) != Ok(expected) {
            return Err(without_its_last_row());
        }
    }
    Ok(photo)
}

fn without_its_last_row() -> PhotoError {
    damaged(Format::Jpeg, "it ends before its last row".to_owned())
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
    let rgb = pixels::to_rgb(decoded, layout).ok_or_else(|| PhotoError::UnsupportedFeature {
        format: format.name(),
        reason: format!("{layout:?} pixels"),
    })?;
    upright(width, height, rgb, icc::told(&profile), &exif)
}

/// The picture in sRGB, turned upright by its EXIF block.
pub(crate) fn upright(
    width: u32,
    height: u32,
    mut rgb: Vec<u8>,
    colours: Told,
    exif: &[u8],
) -> Result<Photo, PhotoError> {
    if let Told::Otherwise(conversion) = colours {
        conversion.apply(&mut rgb);
    }
    let exif = Exif::read(exif, width, height);
    let photo = orientation::apply(Photo::from_rgb(width, height, rgb)?, exif.orientation);
    Ok(photo.with_focal_length_35mm(exif.focal_length_35mm))
}

fn refused(format: Format, error: ImageError) -> PhotoError {
    match error {
        ImageError::Unsupported(error) => {
            PhotoError::UnsupportedFeature { format: format.name(), reason: error.to_string() }
        }
        error => damaged(format, error.to_string()),
    }
}

pub(crate) fn damaged(format: Format, reason: String) -> PhotoError {
    PhotoError::Damaged { format: format.name(), reason }
}
