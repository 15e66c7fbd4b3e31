//! The further photos of a face that was seen in several, as files hold them.

use rosto_face::{FaceModel, View};
use serde_json::{Value, json};

use super::source::{found, part_of};
use crate::{ExportError, Picture};

/// Whether the pictures of further photos go into a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pictures {
    /// The face's part of each, its longest side at most so many px.
    UpTo(u32),
    /// None: the file is to hold no photo.
    Left,
}

/// Which photo leads, and what there is of the others; nothing of a face that was seen in one alone.
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
