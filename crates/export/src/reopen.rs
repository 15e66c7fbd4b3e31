use rosto_face::FaceError;
use serde_json::Value;
use thiserror::Error;

use crate::SavedFace;
use crate::glb::{VERSION, fingerprint};
use crate::placed::PlacedPicture;
use crate::saved;

mod chunks;
mod geometry;

use chunks::Chunks;

/// A face read from a file that this crate wrote: a GLB with a [`Source`](crate::Source), or a
/// [project](crate::project).
#[derive(Debug, Clone, PartialEq)]
pub struct Reopened {
    /// The face and its edits.
    pub face: SavedFace,
    /// Whether another program changed the mesh, so that the file looks different from the reopened face.
    pub changed_elsewhere: bool,
}

/// Reason why a file cannot be reopened.
#[derive(Debug, Clone, PartialEq, Error)]
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
    /// The stored face is damaged or no face.
    #[error(transparent)]
    Face(#[from] FaceError),
}

/// Reads a face from a GLB: its photos, with decoded pictures, and the edits.
///
/// Lengths, offsets and sizes are checked before anything is allocated. The history is not interpreted.
///
/// # Errors
/// [`ReopenError`] if the file is not a GLB, is damaged, or was not written by this crate.
pub fn reopen(bytes: &[u8]) -> Result<Reopened, ReopenError> {
    let chunks = Chunks::of(bytes)?;
    let root: Value = serde_json::from_slice(chunks.json).map_err(|_| ReopenError::NotJson)?;
    let extras = &root["scenes"][0]["extras"];
    if extras["rosto"] != "face" {
        return Err(ReopenError::Foreign);
    }
    check_version(&extras["version"], VERSION)?;
    let texture = |placement: &Value| {
        PlacedPicture::part(geometry::view(&root, chunks.binary, &root["images"][0]["bufferView"])?, placement)
    };
    let own = |placement: Option<&Value>| {
        placement.map(|placement| texture(placement).ok_or_else(field("picture"))).transpose()
    };
    let face = saved::read(extras, own)?.painted();
    Ok(Reopened { face, changed_elsewhere: changed_elsewhere(extras, &root, chunks.binary) })
}

/// Error for a missing or invalid field.
pub(crate) fn field(field: &'static str) -> impl FnOnce() -> ReopenError {
    move || ReopenError::Field { field }
}

/// Refuses all versions except `known`.
pub(crate) fn check_version(value: &Value, known: u64) -> Result<(), ReopenError> {
    match value.as_u64().ok_or_else(field("version"))? {
        found if found == known => Ok(()),
        found => Err(ReopenError::Version { found, known }),
    }
}

/// Whether the positions differ from those that the extras were written for.
fn changed_elsewhere(extras: &Value, root: &Value, binary: &[u8]) -> bool {
    let found = geometry::positions(root, binary).map(fingerprint);
    found.as_deref() != extras["positions_fnv1a"].as_str()
}
