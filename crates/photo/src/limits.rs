use crate::PhotoError;

/// Largest accepted picture, checked before the pixels are allocated.
///
/// If you know a file's length, pass it to [`Self::check_length`] before reading. Otherwise read at most
/// [`Self::max_bytes`] + 1 bytes: the extra byte makes [`decode`](crate::decode()) refuse the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Largest file, in bytes; 40 MB by default.
    pub max_bytes: usize,
    /// Largest width × height; 50 megapixels by default.
    pub max_pixels: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { max_bytes: 40_000_000, max_pixels: 50_000_000 }
    }
}

impl Limits {
    /// Checks the length of a file before it is read.
    ///
    /// # Errors
    /// [`PhotoError::TooManyBytes`] if the file is longer than [`Self::max_bytes`].
    pub fn check_length(&self, bytes: u64) -> Result<(), PhotoError> {
        let max_bytes = self.max_bytes as u64;
        if bytes <= max_bytes {
            return Ok(());
        }
        Err(PhotoError::TooManyBytes { found_bytes: bytes, max_bytes })
    }

    /// Checks the size of a picture, in px, before its pixels are decoded.
    ///
    /// # Errors
    /// [`PhotoError::TooManyPixels`] if the picture has more than [`Self::max_pixels`].
    pub fn check_size(&self, width: u32, height: u32) -> Result<(), PhotoError> {
        if u64::from(width) * u64::from(height) <= self.max_pixels {
            return Ok(());
        }
        Err(PhotoError::TooManyPixels { width, height, max_pixels: self.max_pixels })
    }
}
