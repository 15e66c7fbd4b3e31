use std::io::Cursor;

use image::codecs::webp::WebPDecoder;
use image::{ImageDecoder, ImageError};

use crate::code_points::Told;
use crate::exif::Exif;
use crate::format::Format;
use crate::{Limits, Photo, PhotoError, icc, jpeg, orientation, pixels, png, webp};

/// Decodes a JPEG, PNG or WebP file to an upright picture. Of an animation, the first frame.
///
/// # Errors
/// [`PhotoError`], each with what it found. Sizes are refused before the pixels are allocated.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    limits.check_length(bytes.len() as u64)?;
    let format = Format::sniff(bytes)?;
    match format {
        Format::Jpeg => jpeg::decode(bytes, limits),
        Format::Png => png::decode(bytes, limits),
        Format::WebP => {
            webp::check_chunks(bytes)?;
            let decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(|error| refused(format, error))?;
            Stored::read(decoder, format, limits)?.upright()
        }
    }
}

/// A picture as its file stores it: in its own colours, and not yet turned.
pub(crate) struct Stored {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Three bytes for each pixel, row by row.
    pub(crate) rgb: Vec<u8>,
    /// How opaque each pixel is, if any of them is not.
    pub(crate) alpha: Option<Vec<u8>>,
    pub(crate) colours: Told,
    pub(crate) exif: Vec<u8>,
}

impl Stored {
    pub(crate) fn read(mut decoder: impl ImageDecoder, format: Format, limits: &Limits) -> Result<Self, PhotoError> {
        let (width, height) = decoder.dimensions();
        limits.check_size(width, height)?;
        // Broken metadata is no reason to refuse the picture.
        let exif = decoder.exif_metadata().ok().flatten().unwrap_or_default();
        let profile = decoder.icc_profile().ok().flatten().unwrap_or_default();
        let layout = decoder.color_type();
        let mut decoded = vec![0; width as usize * height as usize * usize::from(layout.bytes_per_pixel())];
        decoder.read_image(&mut decoded).map_err(|error| refused(format, error))?;
        let (rgb, alpha) = pixels::to_rgb(decoded, layout).ok_or_else(|| PhotoError::UnsupportedFeature {
            format: format.name(),
            reason: format!("{layout:?} pixels"),
        })?;
        Ok(Self { width, height, rgb, alpha, colours: icc::told(&profile, layout), exif })
    }

    /// The picture in sRGB, turned upright by its EXIF block.
    pub(crate) fn upright(mut self) -> Result<Photo, PhotoError> {
        if let Told::Otherwise(conversion) = self.colours {
            conversion.apply(&mut self.rgb);
        }
        let exif = Exif::read(&self.exif, self.width, self.height);
        let photo = Photo::from_rgb(self.width, self.height, self.rgb)?.with_valid_alpha(self.alpha);
        let photo = orientation::apply(photo, exif.orientation);
        Ok(photo.with_focal_length_35mm(exif.focal_length_35mm))
    }
}

pub(crate) fn refused(format: Format, error: ImageError) -> PhotoError {
    match error {
        ImageError::Unsupported(error) => unsupported(format, error.to_string()),
        error => damaged(format, error.to_string()),
    }
}

pub(crate) fn damaged(format: Format, reason: String) -> PhotoError {
    PhotoError::Damaged { format: format.name(), reason }
}

pub(crate) fn unsupported(format: Format, reason: String) -> PhotoError {
    PhotoError::UnsupportedFeature { format: format.name(), reason }
}
