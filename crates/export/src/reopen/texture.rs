use std::borrow::Cow;

use serde_json::Value;

use super::fields::{base64, bounded, index, size};
use super::geometry::view;

/// Longest side of a picture that this crate writes, in px.
pub(crate) const MAX_PICTURE_SIDE_PX: u32 = 8192;

/// A picture in a file, and its placement in the whole upright picture.
///
/// Scale it to fill the rectangle `at_px`, `size_px`: another program may have resized it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedTexture<'a> {
    /// The encoded picture, unchanged.
    pub encoded: Cow<'a, [u8]>,
    /// Width and height of the whole upright picture, in px.
    pub picture_size_px: [u32; 2],
    /// Left and top in the whole picture, in px; negative if the texture extends beyond it.
    pub at_px: [i32; 2],
    /// Width and height in the whole picture, in px.
    pub size_px: [u32; 2],
}

impl PlacedTexture<'_> {
    /// `image/png` or `image/jpeg`.
    pub fn media_type(&self) -> &'static str {
        if self.encoded.starts_with(&PNG_SIGNATURE) { "image/png" } else { "image/jpeg" }
    }
}

pub(crate) const PNG_SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";

/// Reads the photo's part from a GLB: the texture itself, or the JPEG in the extras if the texture is a whole-face
/// texture.
pub(super) fn texture<'a>(picture: &Value, root: &Value, binary: &'a [u8]) -> Option<PlacedTexture<'a>> {
    let [left, top] = picture["crop_at_px"].as_array()?.as_slice() else { return None };
    let beyond = |at: &i32| at.unsigned_abs() <= MAX_PICTURE_SIDE_PX;
    let coordinate = |value: &Value| i32::try_from(value.as_i64()?).ok().filter(beyond);
    let encoded = match picture.get("jpeg") {
        Some(embedded) => Cow::Owned(base64(embedded)?),
        None => Cow::Borrowed(view(root, binary, index(&root["images"][0]["bufferView"])?)?),
    };
    let picture_size_px = size(&picture["size_px"], MAX_PICTURE_SIDE_PX)?;
    let size_px = size(&picture["crop_size_px"], MAX_PICTURE_SIDE_PX)?;
    if encoded.is_empty() || encoded_size(&encoded).is_some_and(|size| bounded(size, MAX_PICTURE_SIDE_PX).is_none()) {
        return None;
    }
    Some(PlacedTexture { encoded, picture_size_px, at_px: [coordinate(left)?, coordinate(top)?], size_px })
}

/// Width and height in the header of a JPEG or PNG file.
fn encoded_size(file: &[u8]) -> Option<[u32; 2]> {
    png_size(file).or_else(|| jpeg_size(file))
}

/// Width and height in the header of a PNG file.
pub(crate) fn png_size(file: &[u8]) -> Option<[u32; 2]> {
    let header = file.strip_prefix(&PNG_SIGNATURE)?.get(4..16)?.strip_prefix(b"IHDR")?;
    let side = |at: usize| header.get(at..)?.first_chunk().map(|&bytes| u32::from_be_bytes(bytes));
    Some([side(0)?, side(4)?])
}

/// Width and height in the frame header of a JPEG file, where the height comes first, after the length and precision.
fn jpeg_size(file: &[u8]) -> Option<[u32; 2]> {
    let mut rest = file.strip_prefix(&[0xFF, 0xD8])?;
    loop {
        let &[0xFF, marker, high, low] = rest.first_chunk()? else { return None };
        if matches!(marker, 0xC0..=0xC3 | 0xC5..=0xC7 | 0xC9..=0xCB | 0xCD..=0xCF) {
            let side = |at: usize| rest.get(at..)?.first_chunk().map(|&bytes| u16::from_be_bytes(bytes).into());
            return Some([side(7)?, side(5)?]);
        }
        rest = rest.get(2 + usize::from(u16::from_be_bytes([high, low]))..)?;
    }
}
