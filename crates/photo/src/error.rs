use thiserror::Error;

/// Why bytes did not become a picture.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PhotoError {
    /// The first bytes are those of no picture format.
    #[error("this is not a picture: its first bytes are those of no picture format")]
    NotAPicture,
    /// A picture, but in a format that is not read.
    #[error("{format} pictures are not supported")]
    UnsupportedFormat {
        /// Name of the format.
        format: &'static str,
    },
    /// JPEG, PNG or WebP, but with a feature that is not read.
    #[error("this kind of {format} is not supported: {reason}")]
    UnsupportedFeature {
        /// Name of the format.
        format: &'static str,
        /// The feature.
        reason: String,
    },
    /// The file breaks off or contradicts itself.
    #[error("this {format} picture is damaged: {reason}")]
    Damaged {
        /// Name of the format.
        format: &'static str,
        /// What the decoder said.
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
    /// Width, height and number of bytes do not fit together, or there is no pixel.
    #[error("{found_bytes} bytes are not {width}×{height} pixels")]
    WrongLength {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
        /// Number of bytes given.
        found_bytes: usize,
    },
}

impl PhotoError {
    /// What the person who chose the picture can do about it.
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
            Self::WrongLength { .. } => "Give three bytes for each pixel, row by row.",
        }
    }
}

/// Megapixels with one decimal, rounded up, so that what is too large never looks as if it were not.
fn more_than(width: u32, height: u32) -> String {
    tenths((u64::from(width) * u64::from(height)).div_ceil(100_000))
}

/// The same, rounded down.
fn at_most(pixels: u64) -> String {
    tenths(pixels / 100_000)
}

fn tenths(tenths: u64) -> String {
    if tenths.is_multiple_of(10) { (tenths / 10).to_string() } else { format!("{}.{}", tenths / 10, tenths % 10) }
}
