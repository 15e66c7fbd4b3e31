use rosto_photo::PhotoError;
use thiserror::Error;

use crate::{MOST_SHOTS, SIDES_PX};

/// Why a texture cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TextureError {
    /// The side is too short, too long, or no power of two.
    #[error("a texture's side must be a power of two from {} to {} px, not {side_px}", SIDES_PX.start(), SIDES_PX.end())]
    Side {
        /// The side asked for.
        side_px: u32,
    },
    /// There is no photo, or there are too many.
    #[error("a texture is made of 1 to {MOST_SHOTS} photos, not {found}")]
    ShotCount {
        /// Photos given.
        found: usize,
    },
    /// There is not one value for each vertex.
    #[error("{found} {what} for {expected} vertices")]
    WrongLength {
        /// What there is a wrong number of.
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// A value is infinite or not a number.
    #[error("{what} of vertex {vertex} is not finite")]
    NotFinite {
        /// What has such a value.
        what: &'static str,
        /// The first vertex that does.
        vertex: usize,
    },
    /// A vertex is named that the mesh does not have.
    #[error("vertex {vertex} is named among {what}, and the mesh has {vertex_count}")]
    VertexOutOfRange {
        /// Where it is named.
        what: &'static str,
        /// The first such vertex.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// No texel shows the mesh: it has no area in its texture coordinates, or lies outside of 0..=1.
    #[error("the mesh covers nothing of its texture")]
    NoArea,
    /// All of the mesh is turned away from its photos, hidden, or beside them.
    #[error("none of the {shots} photos shows anything of the mesh")]
    NothingSeen {
        /// Photos given.
        shots: usize,
    },
    /// The picture cannot be made.
    #[error(transparent)]
    Photo(#[from] PhotoError),
}
