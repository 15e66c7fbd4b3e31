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

/// A face out of a file that this crate wrote: a GLB with a [`Source`](crate::Source), or a [project](crate::project). All
/// that opens it again, and nothing that could not be opened: the landmarks are those of a face, and no side is 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Reopened<'a> {
    /// 468 landmarks, or 478 with the irises, in MediaPipe's normalised convention (x/W, y/H, z/W), bit for bit as they were
    /// found.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo that they were found in.
    pub photo_size_px: [u32; 2],
    /// What was known of the photo's lens.
    pub lens: PhotoLens,
    /// 468 sRGB colours.
    pub colours_srgb: Vec<[u8; 3]>,
    /// How the landmarks are joined.
    pub triangulation: Triangulation,
    /// How often the mesh was subdivided, 0 to 4.
    pub density: u32,
    /// The edits as the text of a JSON object.
    pub history: Option<String>,
    /// What was done to the photo alone, in the same way.
    pub in_photo: Option<String>,
    /// The photo or the part of it that the file holds; none in a GLB that is painted with colours.
    pub texture: Option<PlacedTexture<'a>>,
    /// Of a face in several photos, what there is of the others: all above is of the one that leads.
    pub further: Option<Further>,
    /// Whether the mesh in the file is another one than was written, so that it looks otherwise than what is opened.
    pub changed_elsewhere: bool,
}

/// Why a file cannot be opened again.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReopenError {
    /// It does not begin as a binary glTF 2.0 file does.
    #[error("this is not a binary glTF 2.0 file")]
    NotGlb,
    /// It ends too early.
    #[error("the file has {found} bytes where it promises {expected}")]
    Truncated {
        /// Bytes that the file says it has.
        expected: usize,
        /// Bytes there are.
        found: usize,
    },
    /// Its description is not JSON.
    #[error("the file's description of itself cannot be read")]
    NotJson,
    /// Another program wrote it, or wrote it anew without what Rosto had put in.
    #[error("the file holds no Rosto face")]
    Foreign,
    /// A Rosto of another version wrote it.
    #[error(
        "the file has version {found}, and this Rosto reads version {known} only: open it with the one that wrote it"
    )]
    Version {
        /// The version in the file.
        found: u64,
        /// The version that is read.
        known: u64,
    },
    /// Something is missing or not as expected.
    #[error("the file has no usable {field:?}")]
    Field {
        /// The field's name.
        field: &'static str,
    },
}

/// Reads what makes a face out of a GLB: landmarks, colours, the texture and its place, and the edits.
///
/// Nothing of a stranger's file is trusted: every length and place is checked, and no picture is decoded. Whether the
/// history is one is for its owner to say.
///
/// # Errors
/// [`ReopenError`] for what is no GLB, is damaged, was not written by this crate, or could not be opened.
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

/// Lens data.
pub(crate) fn lens(text: &Value) -> Result<PhotoLens, ReopenError> {
    text.as_str().and_then(|text| text.parse().ok()).ok_or_else(field("lens"))
}

/// What was done to the photo alone, if the file tells of any.
pub(crate) fn in_photo(fields: &Value) -> Result<Option<String>, ReopenError> {
    fields.get("in_photo").map(|edits| object(edits).ok_or_else(field("in_photo"))).transpose()
}

pub(crate) fn triangulation(name: &Value) -> Result<Triangulation, ReopenError> {
    name.as_str().and_then(Triangulation::from_id).ok_or_else(field("triangulation"))
}

/// Whether the positions are others than those that the extras tell of.
fn changed_elsewhere(extras: &Value, root: &Value, binary: &[u8]) -> bool {
    let found = geometry::positions(root, binary).map(fingerprint);
    found.as_deref() != extras["positions_fnv1a"].as_str()
}
