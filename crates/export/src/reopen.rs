use serde_json::Value;

use crate::glb::{VERSION, fingerprint};
use crate::placed::PlacedPicture;
use crate::reopen_error::{check_version, field};
use crate::{ReopenError, SavedFace, saved};

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

/// Whether the positions differ from those that the extras were written for.
fn changed_elsewhere(extras: &Value, root: &Value, binary: &[u8]) -> bool {
    let found = geometry::positions(root, binary).map(fingerprint);
    found.as_deref() != extras["positions_fnv1a"].as_str()
}
