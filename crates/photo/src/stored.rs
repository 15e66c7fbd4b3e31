use std::sync::Arc;

use image::imageops::{flip_horizontal_in_place, flip_vertical_in_place, rotate90, rotate180_in_place, rotate270};
use image::metadata::Orientation;
use image::{ImageBuffer, Luma, Pixel, Rgb};

use crate::code_points::ColourEncoding;
use crate::exif::Exif;
use crate::{Photo, PhotoError};

/// A decoded picture in the file's colour encoding and orientation.
pub(crate) struct Stored {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// RGB bytes, three per pixel, row by row.
    pub(crate) rgb: Vec<u8>,
    /// Opacity of each pixel; `None` if all are opaque.
    pub(crate) alpha: Option<Vec<u8>>,
    pub(crate) colours: ColourEncoding,
    pub(crate) exif: Vec<u8>,
}

impl Stored {
    /// Converts to sRGB and applies the EXIF orientation.
    pub(crate) fn upright(mut self) -> Result<Photo, PhotoError> {
        if let ColourEncoding::Converted(conversion) = self.colours {
            conversion.apply(&mut self.rgb);
        }
        let (width, height) = (self.width, self.height);
        let exif = Exif::read(&self.exif, width, height);
        let wrong_length = PhotoError::WrongLength { width, height, found_bytes: self.rgb.len() };
        let picture = oriented::<Rgb<u8>>([width, height], self.rgb, exif.orientation).ok_or(wrong_length)?;
        let alpha = self.alpha.and_then(|alpha| oriented::<Luma<u8>>([width, height], alpha, exif.orientation));
        let mut photo = Photo::from_rgb(picture.width(), picture.height(), picture.into_raw())?;
        photo.alpha = alpha.map(|alpha| Arc::new(alpha.into_raw()));
        photo.focal_length_35mm = exif.focal_length_35mm;
        Ok(photo)
    }
}

/// Applies an orientation to a stored picture.
fn oriented<P: Pixel<Subpixel = u8> + 'static>(
    [width, height]: [u32; 2],
    stored: Vec<u8>,
    orientation: Orientation,
) -> Option<ImageBuffer<P, Vec<u8>>> {
    use Orientation::{FlipHorizontal, FlipVertical, Rotate90, Rotate90FlipH, Rotate180, Rotate270, Rotate270FlipH};
    let mut picture: ImageBuffer<P, Vec<u8>> = ImageBuffer::from_raw(width, height, stored)?;
    match orientation {
        Rotate90 | Rotate90FlipH => picture = rotate90(&picture),
        Rotate270 | Rotate270FlipH => picture = rotate270(&picture),
        Rotate180 => rotate180_in_place(&mut picture),
        FlipVertical => flip_vertical_in_place(&mut picture),
        Orientation::NoTransforms | FlipHorizontal => {}
    }
    if matches!(orientation, FlipHorizontal | Rotate90FlipH | Rotate270FlipH) {
        flip_horizontal_in_place(&mut picture);
    }
    Some(picture)
}
