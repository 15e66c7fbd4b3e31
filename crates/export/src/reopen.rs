use rosto_face::{PhotoLens, Triangulation};
use serde_json::Value;
use thiserror::Error;

use crate::glb::{VERSION, fingerprint};

mod chunks;
pub(crate) mod fields;
mod further;
mod geometry;
mod painted;
pub(crate) mod texture;

use chunks::Chunks;
use fields::{base64, check_version, colours, density, field, landmarks, object, size};
pub(crate) use further::further_photos;
pub use further::{Further, FurtherPhoto};
pub use painted::Painted;
pub use texture::PlacedTexture;

/// A face read from a file that this crate wrote: a GLB with a [`Source`](crate::Source), or a
/// [project](crate::project).
///
/// The data are validated: the landmarks form a face, and no side is 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Reopened<'a> {
    /// 468 landmarks, or 478 with the irises, in MediaPipe's normalised coordinates (x/W, y/H, z/W), unchanged bit for
    /// bit.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// Lens data of the photo.
    pub lens: PhotoLens,
    /// 468 sRGB colours.
    pub colours_srgb: Vec<[u8; 3]>,
    /// Triangulation of the landmarks.
    pub triangulation: Triangulation,
    /// Subdivision level, 0 to 4.
    pub density: u32,
    /// Edits as the text of a JSON object.
    pub history: Option<String>,
    /// Edits of the photo, in the same form.
    pub in_photo: Option<String>,
    /// The photo, or the part of it in the file; `None` in a GLB with vertex colours.
    pub texture: Option<PlacedTexture<'a>>,
    /// The further photos of a face from several; the other fields describe the lead photo.
    pub further: Option<Further>,
    /// Whether another program changed the mesh, so that the file looks different from the reopened face.
    pub changed_elsewhere: bool,
}

/// Reason why a file cannot be reopened.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReopenError {
    /// The file does not start as binary glTF 2.0.
    #[error("this is not a binary glTF 2.0 file")]
    NotGlb,
    /// The file is truncated.
    #[error("the file has {found} bytes; its header says {expected}")]
    Truncated {
        /// Length according to the header.
        expected: usize,
        /// Actual length.
        found: usize,
    },
    /// The file's JSON is malformed.
    #[error("the file's JSON header cannot be read")]
    NotJson,
    /// Another program wrote the file, or rewrote it without Rosto's data.
    #[error("the file does not contain a Rosto face")]
    Foreign,
    /// Another version of Rosto wrote the file.
    #[error(
        "the file has version {found}, but this Rosto reads only version {known}; open it with the Rosto that wrote it"
    )]
    Version {
        /// Version of the file.
        found: u64,
        /// Supported version.
        known: u64,
    },
    /// A field is missing or invalid.
    #[error("the field {field:?} is missing or invalid")]
    Field {
        /// Name of the field.
        field: &'static str,
    },
}

/// Reads a face from a GLB: landmarks, colours, the texture with its placement, and the edits.
///
/// Lengths and offsets are checked, and no picture is decoded. The history is not interpreted.
///
/// # Errors
/// [`ReopenError`] if the file is not a GLB, is damaged, or was not written by this crate.
pub fn reopen(bytes: &[u8]) -> Result<Reopened<'_>, ReopenError> {
    let chunks = Chunks::of(bytes)?;
    let root: Value = serde_json::from_slice(chunks.json).map_err(|_| ReopenError::NotJson)?;
    let extras = &root["scenes"][0]["extras"];
    if extras["rosto"] != "face" {
        return Err(ReopenError::Foreign);
    }
    check_version(&extras["version"], VERSION)?;
    let numbers = base64(&extras["landmarks"]).ok_or_else(field("landmarks"))?;
    let photo_size_px = size(&extras["photo_px"], u32::MAX).ok_or_else(field("photo_px"))?;
    let landmarks = landmarks(&numbers, photo_size_px).ok_or_else(field("landmarks"))?;
    let texture = |picture| texture::texture(picture, &root, chunks.binary).ok_or_else(field("picture"));
    Ok(Reopened {
        photo_size_px,
        colours_srgb: base64(&extras["colours"]).and_then(|bytes| colours(&bytes)).ok_or_else(field("colours"))?,
        triangulation: triangulation(&extras["triangulation"])?,
        density: density(&extras["density"]).ok_or_else(field("density"))?,
        lens: lens(&extras["lens"])?,
        history: extras.get("history").map(|history| object(history).ok_or_else(field("history"))).transpose()?,
        in_photo: in_photo(extras)?,
        texture: extras.get("picture").map(texture).transpose()?,
        further: further_photos(extras.get("further"))?,
        changed_elsewhere: changed_elsewhere(extras, &root, chunks.binary),
        landmarks,
    })
}

/// Parses lens data.
pub(crate) fn lens(text: &Value) -> Result<PhotoLens, ReopenError> {
    text.as_str().and_then(|text| text.parse().ok()).ok_or_else(field("lens"))
}

/// Edits of the photo, if the file has any.
pub(crate) fn in_photo(fields: &Value) -> Result<Option<String>, ReopenError> {
    fields.get("in_photo").map(|edits| object(edits).ok_or_else(field("in_photo"))).transpose()
}

pub(crate) fn triangulation(name: &Value) -> Result<Triangulation, ReopenError> {
    name.as_str().and_then(Triangulation::from_id).ok_or_else(field("triangulation"))
}

/// Whether the positions differ from those that the extras were written for.
fn changed_elsewhere(extras: &Value, root: &Value, binary: &[u8]) -> bool {
    let found = geometry::positions(root, binary).map(fingerprint);
    found.as_deref() != extras["positions_fnv1a"].as_str()
}
