//! The further photos of a face that was fitted to several.

use rosto_face::{FaceModel, View};
use serde_json::{Value, json};

use super::source::{found, part_of};
use crate::{ExportError, Picture};

/// Whether a file includes the pictures of further photos.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pictures {
    /// The face's part of each, with a longest side of at most this many px.
    UpTo(u32),
    /// No pictures, because the file should not contain photos.
    Left,
}

/// Returns the index of the lead photo and the data of the others; `None` for a face from a single photo.
pub(crate) fn further(face: &FaceModel, pictures: Pictures) -> Result<Option<Value>, ExportError> {
    let [lead, others @ ..] = face.views() else { return Ok(None) };
    if others.is_empty() {
        return Ok(None);
    }
    let photos = others.iter().map(|view| photo(view, pictures));
    Ok(Some(json!({"leads": lead.photo, "photos": photos.collect::<Result<Vec<_>, _>>()?})))
}

fn photo(view: &View, pictures: Pictures) -> Result<Value, ExportError> {
    let mut photo = found(view.photo_size_px, view.lens, &view.landmarks, &view.colours_srgb);
    if let Pictures::UpTo(max_px) = pictures {
        photo["picture"] = part_of(&Picture { pixels: &view.picture, uvs: &view.uvs }, max_px)?;
    }
    Ok(photo)
}
