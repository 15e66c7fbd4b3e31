use crate::PhotoError;

/// A supported file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Jpeg,
    Png,
    WebP,
}

impl Format {
    /// Detects the format by the first bytes, since a file name can be wrong.
    pub(crate) fn sniff(bytes: &[u8]) -> Result<Self, PhotoError> {
        match bytes {
            [0xFF, 0xD8, 0xFF, ..] => Ok(Self::Jpeg),
            [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1A, b'\n', ..] => Ok(Self::Png),
            [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Ok(Self::WebP),
            _ => Err(foreign_format(bytes)
                .map_or(PhotoError::NotAPicture, |format| PhotoError::UnsupportedFormat { format })),
        }
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Jpeg => "JPEG",
            Self::Png => "PNG",
            Self::WebP => "WebP",
        }
    }

    pub(crate) fn damaged(self, reason: impl ToString) -> PhotoError {
        PhotoError::Damaged { format: self.name(), reason: reason.to_string() }
    }

    pub(crate) fn unsupported(self, reason: impl ToString) -> PhotoError {
        PhotoError::UnsupportedFeature { format: self.name(), reason: reason.to_string() }
    }
}

/// Returns the name of a picture format that is recognised but not supported.
fn foreign_format(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [_, _, _, _, b'f', b't', b'y', b'p', ..] => iso_media_format(bytes),
        [0x8A, b'M', b'N', b'G', ..] => Some("MNG"),
        [0x8B, b'J', b'N', b'G', ..] => Some("JNG"),
        [b'G', b'I', b'F', b'8', ..] => Some("GIF"),
        [b'B', b'M', _, _, _, _, 0, 0, 0, 0, ..] => Some("BMP"),
        [b'I', b'I', 42, 0, ..] | [b'M', b'M', 0, 42, ..] => Some("TIFF"),
        [0xFF, 0x0A, ..] | [0, 0, 0, 0x0C, b'J', b'X', b'L', b' ', ..] => Some("JPEG XL"),
        [0, 0, 0, 0x0C, b'j', b'P', b' ', b' ', ..] => Some("JPEG 2000"),
        [b'8', b'B', b'P', b'S', ..] => Some("Photoshop"),
        _ => None,
    }
}

/// HEIC and AVIF share a container and differ in their brands.
///
/// The major brand (followed by a 4-byte version) decides, unless it fits both formats; then the compatible brands do.
fn iso_media_format(bytes: &[u8]) -> Option<&'static str> {
    let length = u32::from_be_bytes(*bytes.first_chunk()?) as usize;
    let brands = bytes.get(8..length.clamp(12, bytes.len().max(12)))?.as_chunks::<4>().0;
    let others = brands.iter().skip(2);
    brands.iter().take(1).chain(others).find_map(format_of_brand).or_else(|| match brands.first()? {
        b"mif1" | b"mif2" | b"msf1" | b"miaf" => Some("HEIF"),
        _ => None,
    })
}

fn format_of_brand(brand: &[u8; 4]) -> Option<&'static str> {
    match brand {
        b"heic" | b"heix" | b"heim" | b"heis" | b"hevc" | b"hevx" | b"hevm" | b"hevs" => Some("HEIC"),
        b"avif" | b"avis" => Some("AVIF"),
        _ => None,
    }
}
