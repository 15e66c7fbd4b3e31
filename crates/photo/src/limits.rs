use crate::PhotoError;

/// How large a picture may be. Checked before the pixels are allocated.
///
/// Whoever reads a file asks [`Self::check_length`] first where its length is known, and reads one byte more than
/// [`Self::max_bytes`] at most where it is not: that byte is enough for [`decode`](crate::decode()) to refuse it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Largest file, in bytes. 40 MB by default.
    pub max_bytes: usize,
    /// Largest width × height. 50 megapixels by default.
    pub max_pixels: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { max_bytes: 40_000_000, max_pixels: 50_000_000 }
    }
}

impl Limits {
    /// Refuses a file by its length, before any of it is read.
    ///
    /// # Errors
    /// [`PhotoError::TooManyBytes`].
    pub fn check_length(&self, bytes: u64) -> Result<(), PhotoError> {
        let max_bytes = self.max_bytes as u64;
        if bytes <= max_bytes {
            return Ok(());
        }
        Err(PhotoError::TooManyBytes { found_bytes: bytes, max_bytes })
    }

    /// Refuses a picture by its size in px, before its pixels are decoded.
    ///
    /// # Errors
    /// [`PhotoError::TooManyPixels`].
    pub fn check_size(&self, width: u32, height: u32) -> Result<(), PhotoError> {
        if u64::from(width) * u64::from(height) <= self.max_pixels {
            return Ok(());
        }
        Err(PhotoError::TooManyPixels { width, height, max_pixels: self.max_pixels })
    }
}
