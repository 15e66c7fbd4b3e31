//! Valid files of every kind.

mod faces;
mod pictures;
mod profiles;

use crate::Kind;

pub use faces::canonical_rest;
pub use pictures::with_profile;

/// The seeds of a kind.
pub fn of(kind: Kind) -> Vec<Vec<u8>> {
    match kind {
        Kind::Picture => pictures::all(),
        Kind::Profile => profiles::all(),
        Kind::Glb => faces::glbs(),
        Kind::Project => faces::projects(),
        Kind::Edits => faces::histories().into_iter().map(String::into_bytes).collect(),
    }
}
