use thiserror::Error;

/// Reason why bytes could not be decoded to a picture.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PhotoError {
    /// The first bytes match no known picture format.
    #[error("this is not a picture: its first bytes match no known picture format")]
    NotAPicture,
    /// A recognised picture format that is not supported.
    #[error("{format} pictures are not supported")]
    UnsupportedFormat {
        /// Name of the format.
        format: &'static str,
    },
    /// JPEG, PNG or WebP with an unsupported feature.
    #[error("this kind of {format} is not supported: {reason}")]
    UnsupportedFeature {
        /// Name of the format.
        format: &'static str,
        /// The unsupported feature.
        reason: String,
    },
    /// The file is truncated or inconsistent.
    #[error("this {format} picture is damaged: {reason}")]
    Damaged {
        /// Name of the format.
        format: &'static str,
        /// The decoder's message.
        reason: String,
    },
    /// The file is larger than [`Limits::max_bytes`](crate::Limits::max_bytes).
    #[error("the file has {found_bytes} bytes; the limit is {max_bytes}")]
    TooManyBytes {
        /// Length of the file.
        found_bytes: u64,
        /// The limit.
        max_bytes: u64,
    },
    /// The picture is larger than [`Limits::max_pixels`](crate::Limits::max_pixels).
    #[error("the picture is {width}×{height} px, {} megapixels; the limit is {}", more_than(*.width, *.height), at_most(*.max_pixels))]
    TooManyPixels {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
        /// The limit on width × height.
        max_pixels: u64,
    },
    /// The number of bytes does not match width × height, or the picture is empty.
    #[error("{found_bytes} bytes do not match {width}×{height} pixels")]
    WrongLength {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
        /// Number of bytes passed.
        found_bytes: usize,
    },
}

impl PhotoError {
    /// Returns advice for the user who chose the picture.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::NotAPicture => "Choose a JPEG, PNG or WebP picture.",
            Self::UnsupportedFormat { format: "HEIC" } => {
                "Export it as JPEG. On an iPhone, Settings › Camera › Formats › Most Compatible takes photos as JPEG."
            }
            Self::UnsupportedFormat { .. } => "Open it in a picture editor and save it as JPEG or PNG.",
            Self::UnsupportedFeature { .. } => "Save it as a standard JPEG or as PNG in a picture editor.",
            Self::Damaged { .. } => {
                "The file may have been cut short or changed while copying: copy or download it again."
            }
            Self::TooManyBytes { .. } | Self::TooManyPixels { .. } => "Scale the picture down or crop it to the face.",
            Self::WrongLength { .. } => "Pass three bytes per pixel, row by row.",
        }
    }
}

/// Megapixels with one decimal, rounded up, so that a picture over the limit is not shown as equal to it.
fn more_than(width: u32, height: u32) -> String {
    tenths((u64::from(width) * u64::from(height)).div_ceil(100_000))
}

/// Megapixels with one decimal, rounded down.
fn at_most(pixels: u64) -> String {
    tenths(pixels / 100_000)
}

fn tenths(tenths: u64) -> String {
    if tenths.is_multiple_of(10) { (tenths / 10).to_string() } else { format!("{}.{}", tenths / 10, tenths % 10) }
}
