//! The project file: a face with its edits and its lossless photo.
//!
//! A line of JSON, then the lead photo's upright picture as a PNG file. The line is a [`Source`]'s fields with
//! `"format": "rosto-project"` and `"version": 1`; the other photos are stored in it, each with the face's part as JPEG.

use serde_json::Value;

use crate::placed::PlacedPicture;
use crate::reopen_error::{check_version, field};
use crate::saved::{Pictures, fields, read as read_fields};
use crate::sniff::without_bom;
use crate::{ExportError, ReopenError, Reopened, Source, texture};

const FORMAT: &str = "rosto-project";

/// Last bytes of a PNG file: its chunk `IEND`.
const PNG_END: &[u8] = b"\0\0\0\0IEND\xAE\x42\x60\x82";

/// Format version that is written and read.
const VERSION: u64 = 1;

/// Longest side of a further photo's picture, in px.
const MAX_FURTHER_PX: u32 = 2048;

/// Writes a project (`application/octet-stream`).
///
/// # Errors
/// [`ExportError::NoPicture`] if the face was built without its picture, [`ExportError::HistoryNotAnObject`], or
/// [`ExportError::Texture`].
pub fn write(source: &Source<'_>) -> Result<Vec<u8>, ExportError> {
    let png = texture::png(source.face.picture().ok_or(ExportError::NoPicture)?)?;
    let mut header = fields(source, None, Pictures::UpTo(MAX_FURTHER_PX))?;
    header["version"] = VERSION.into();
    // The format's name comes first, where `sniff` finds it.
    let mut file = format!("{{\"format\":\"{FORMAT}\",{}\n", &header.to_string()[1..]).into_bytes();
    file.extend(png);
    Ok(file)
}

/// Reads a project.
///
/// # Errors
/// [`ReopenError`] if the file is not a project, is damaged, or has another version.
pub fn read(bytes: &[u8]) -> Result<Reopened, ReopenError> {
    let text = without_bom(bytes).trim_ascii_start();
    if !text.starts_with(b"{") {
        return Err(ReopenError::Foreign);
    }
    let line = text.iter().position(|&byte| byte == b'\n').ok_or(ReopenError::NotJson)?;
    let header: Value = serde_json::from_slice(&text[..line]).map_err(|_| ReopenError::NotJson)?;
    if header["format"] != FORMAT {
        return Err(ReopenError::Foreign);
    }
    check_version(&header["version"], VERSION)?;
    let png = &text[line + 1..];
    // Decoders accept a PNG without its end.
    if !png.ends_with(PNG_END) {
        return Err(field("picture")());
    }
    let own = |placement: Option<&Value>| match placement {
        None => Ok(Some(PlacedPicture::whole(png))),
        Some(_) => Err(field("picture")()),
    };
    Ok(Reopened { face: read_fields(&header, own)?, changed_elsewhere: false })
}
