use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use crate::exif::Exif;
use crate::{PhotoError, pixels, resize};

/// An upright sRGB picture: 8-bit RGB, row-major, origin at the top left, at least one pixel.
///
/// Transparent pixels are blended over white; their opacity and the focal length from EXIF are stored separately.
/// Clones share the pixels.
#[derive(Clone, PartialEq, Eq)]
pub struct Photo {
    width: u32,
    height: u32,
    pixels: Arc<Vec<u8>>,
    /// One byte per pixel; `None` if all pixels are opaque.
    pub(crate) alpha: Option<Arc<Vec<u8>>>,
    pub(crate) focal_length_35mm: Option<u16>,
}

impl Photo {
    /// Creates a picture from RGB bytes, three per pixel.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 3`, or is 0.
    pub fn from_rgb(width: u32, height: u32, pixels: Vec<u8>) -> Result<Self, PhotoError> {
        check_count(width, height, 3, &pixels)?;
        Ok(Self::from_valid(width, height, pixels))
    }

    /// Creates a picture from RGBX bytes, four per pixel, as canvases and cameras provide them; the fourth is ignored.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 4`, or is 0.
    pub fn from_rgbx(width: u32, height: u32, pixels: &[u8]) -> Result<Self, PhotoError> {
        check_count(width, height, 4, pixels)?;
        Ok(Self::from_valid(width, height, pixels::drop_fourth(pixels)))
    }

    /// Creates a picture from RGBA bytes, four per pixel, blended over white.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 4`, or is 0.
    pub fn from_rgba(width: u32, height: u32, pixels: &[u8]) -> Result<Self, PhotoError> {
        check_count(width, height, 4, pixels)?;
        Ok(Self::from_valid(width, height, pixels::over_white(pixels)))
    }

    /// Creates a picture whose length was already checked.
    pub(crate) fn from_valid(width: u32, height: u32, pixels: Vec<u8>) -> Self {
        debug_assert_eq!(width as usize * height as usize * 3, pixels.len());
        Self { width, height, pixels: Arc::new(pixels), alpha: None, focal_length_35mm: None }
    }

    /// Width in px.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in px.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// 35-mm-equivalent focal length in mm, from EXIF's FocalLengthIn35mmFilm.
    ///
    /// `None` if it is missing, outside 8 to 400 mm, or the picture appears to be cropped. A 36 × 24 mm frame has a
    /// diagonal of 43.27 mm, so the focal length in px is this value × the picture's diagonal in px / 43.27.
    pub fn focal_length_35mm(&self) -> Option<f64> {
        self.focal_length_35mm.map(f64::from)
    }

    /// Takes the focal length from the HEIC or AVIF file from which another decoder produced this photo.
    pub fn with_lens_of(self, container: &[u8]) -> Self {
        let focal_length_35mm = Exif::focal_length_35mm_in_container(container, self.width, self.height);
        Self { focal_length_35mm, ..self }
    }

    /// RGB bytes, three per pixel, row by row from the top.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Opacity of each pixel, row by row from the top: 0 is transparent, 255 opaque. `None` if all pixels are opaque.
    pub fn alpha(&self) -> Option<&[u8]> {
        self.alpha.as_deref().map(Vec::as_slice)
    }

    /// Sets the opacity with which the pixels were blended over white, one byte per pixel.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if there is not one byte per pixel.
    pub fn with_alpha(self, alpha: Vec<u8>) -> Result<Self, PhotoError> {
        if alpha.len() * 3 != self.pixels.len() {
            let (width, height) = (self.width, self.height);
            return Err(PhotoError::WrongLength { width, height, found_bytes: alpha.len() });
        }
        Ok(Self { alpha: Some(Arc::new(alpha)), ..self })
    }

    /// RGBA bytes, row by row, with the blend over white undone.
    pub fn rgba(&self) -> Vec<u8> {
        pixels::to_rgba(&self.pixels, self.alpha())
    }

    /// The part of [`Self::rgba`] for some rows.
    ///
    /// # Panics
    /// If a row is outside the picture.
    pub fn rgba_rows(&self, rows: Range<u32>) -> Vec<u8> {
        let [start, end] = [rows.start, rows.end].map(|row| row as usize * self.width as usize);
        pixels::to_rgba(&self.pixels[3 * start..3 * end], self.alpha().map(|alpha| &alpha[start..end]))
    }

    /// RGBX bytes (the fourth is 255), row by row, blended over white.
    pub fn rgbx(&self) -> Vec<u8> {
        pixels::to_rgba(&self.pixels, None)
    }

    /// RGB of one pixel.
    ///
    /// # Panics
    /// If `x` or `y` is outside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        assert!(x < self.width && y < self.height, "pixel ({x}, {y}) of {}×{}", self.width, self.height);
        let start = (y as usize * self.width as usize + x as usize) * 3;
        [self.pixels[start], self.pixels[start + 1], self.pixels[start + 2]]
    }

    /// Colour at a normalised position (0 at the left and top edge, 1 at the right and bottom edge).
    ///
    /// As in the paper: pixel (⌊x·W⌋, ⌊y·H⌋), clamped to the picture.
    pub fn colour_under(&self, x_normalised: f64, y_normalised: f64) -> [u8; 3] {
        // `as u32` rounds positive values down and saturates; NaN becomes 0.
        let x = (x_normalised * f64::from(self.width)) as u32;
        let y = (y_normalised * f64::from(self.height)) as u32;
        self.pixel(x.min(self.width - 1), y.min(self.height - 1))
    }

    /// Scales the picture down so that its longer side is at most `max_side_px` (at least 1) px.
    ///
    /// A new pixel is the mean of the area that it covers; a smaller picture keeps its pixels. The result is opaque,
    /// blended over white.
    pub fn scaled_down(&self, max_side_px: u32) -> Self {
        let (long, limit) = (self.width.max(self.height), max_side_px.max(1));
        if long <= limit {
            return Self { alpha: None, ..self.clone() };
        }
        let scale = f64::from(limit) / f64::from(long);
        let shrunk = |side: u32| ((f64::from(side) * scale).round() as u32).max(1);
        let (width, height) = (shrunk(self.width), shrunk(self.height));
        let source = self.pixels.as_chunks().0;
        let small = resize::area_mean(source, [self.width, self.height], [width, height]);
        Self { focal_length_35mm: self.focal_length_35mm, ..Self::from_valid(width, height, small) }
    }
}

/// Prints only the size, since there are millions of pixels.
impl fmt::Debug for Photo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Photo({}×{} px)", self.width, self.height)
    }
}

fn check_count(width: u32, height: u32, channels: u128, pixels: &[u8]) -> Result<(), PhotoError> {
    match u128::from(width) * u128::from(height) * channels {
        expected if expected > 0 && expected == pixels.len() as u128 => Ok(()),
        _ => Err(PhotoError::WrongLength { width, height, found_bytes: pixels.len() }),
    }
}
