use std::fmt;
use std::sync::Arc;

use crate::exif::Exif;
use crate::{PhotoError, pixels, resize};

/// An upright sRGB picture: 8-bit RGB, row-major, origin at the top left, at least one pixel; with what the file told of
/// its lens and of transparency, which lies over white in the pixels. Its clones share the pixels.
#[derive(Clone, PartialEq, Eq)]
pub struct Photo {
    width: u32,
    height: u32,
    pixels: Arc<Vec<u8>>,
    /// One byte for each pixel, if any of them is not opaque.
    pub(crate) alpha: Option<Arc<Vec<u8>>>,
    pub(crate) focal_length_35mm: Option<u16>,
}

impl Photo {
    /// A picture from its bytes, three (red, green, blue) for each pixel.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 3`, or 0.
    pub fn from_rgb(width: u32, height: u32, pixels: Vec<u8>) -> Result<Self, PhotoError> {
        check_count(width, height, 3, &pixels)?;
        Ok(Self::from_valid(width, height, pixels))
    }

    /// A picture from its bytes as browsers and cameras hold them: red, green, blue and a fourth, which is passed over, for
    /// each pixel.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 4`, or 0.
    pub fn from_rgbx(width: u32, height: u32, pixels: &[u8]) -> Result<Self, PhotoError> {
        check_count(width, height, 4, pixels)?;
        Ok(Self::from_valid(width, height, pixels::without_the_fourth(pixels)))
    }

    /// A picture from its bytes, four (red, green, blue and opacity) for each pixel, laid over white.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if the number of bytes is not `width · height · 4`, or 0.
    pub fn from_rgba(width: u32, height: u32, pixels: &[u8]) -> Result<Self, PhotoError> {
        check_count(width, height, 4, pixels)?;
        Ok(Self::from_valid(width, height, pixels::over_white(pixels)))
    }

    /// A picture whose size was checked already.
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

    /// The 35-mm-equivalent focal length of the lens in mm, if the file tells one that is sound: EXIF's
    /// FocalLengthIn35mmFilm where it is 8 to 400 mm and nothing says that a part of the picture was cut off.
    ///
    /// A frame of 36 × 24 mm has a diagonal of 43.27 mm, so that the focal length in px is this, times the picture's
    /// diagonal in px, over 43.27.
    pub fn focal_length_35mm(&self) -> Option<f64> {
        self.focal_length_35mm.map(f64::from)
    }

    /// The photo with the lens that another file of it tells: the HEIC or AVIF file that it was decoded from elsewhere.
    pub fn with_lens_of(self, container: &[u8]) -> Self {
        let focal_length_35mm = Exif::focal_length_35mm_in_container(container, self.width, self.height);
        Self { focal_length_35mm, ..self }
    }

    /// All bytes, three for each pixel, row by row from the top.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// How opaque each pixel is, row by row from the top: 0 is transparent, 255 opaque. `None` if all are opaque.
    pub fn alpha(&self) -> Option<&[u8]> {
        self.alpha.as_deref().map(Vec::as_slice)
    }

    /// The photo with the opacity of its pixels, over which its colours were laid on white.
    ///
    /// # Errors
    /// [`PhotoError::WrongLength`] if there is not one byte for each pixel.
    pub fn with_alpha(self, alpha: Vec<u8>) -> Result<Self, PhotoError> {
        if alpha.len() * 3 != self.pixels.len() {
            let (width, height) = (self.width, self.height);
            return Err(PhotoError::WrongLength { width, height, found_bytes: alpha.len() });
        }
        Ok(Self { alpha: Some(Arc::new(alpha)), ..self })
    }

    /// Red, green, blue and opacity of each pixel, row by row: the colours without the white below.
    pub fn rgba(&self) -> Vec<u8> {
        pixels::to_rgba(&self.pixels, self.alpha())
    }

    /// Red, green, blue and 255 of each pixel, row by row, over white.
    pub fn rgbx(&self) -> Vec<u8> {
        pixels::to_rgba(&self.pixels, None)
    }

    /// Red, green and blue of one pixel.
    ///
    /// # Panics
    /// If `x` or `y` is outside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        assert!(x < self.width && y < self.height, "pixel ({x}, {y}) of {}×{}", self.width, self.height);
        let start = (y as usize * self.width as usize + x as usize) * 3;
        [self.pixels[start], self.pixels[start + 1], self.pixels[start + 2]]
    }

    /// The colour under a normalised position (0 at the left and top edge, 1 at the right and bottom one), as the
    /// paper takes it: pixel (⌊x·W⌋, ⌊y·H⌋), clamped to the picture.
    pub fn colour_under(&self, x_normalised: f64, y_normalised: f64) -> [u8; 3] {
        // A cast to an integer rounds down what is positive, and clamps; NaN becomes 0.
        let x = (x_normalised * f64::from(self.width)) as u32;
        let y = (y_normalised * f64::from(self.height)) as u32;
        self.pixel(x.min(self.width - 1), y.min(self.height - 1))
    }

    /// The picture scaled down so that its longer side has at most `max_side_px` pixels (at least 1), each new pixel
    /// the mean of the area it covers. A picture that fits already keeps its pixels. The copy is opaque, over white.
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

/// The size only: nobody wants to read millions of pixels.
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
