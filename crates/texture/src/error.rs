use rosto_photo::PhotoError;
use thiserror::Error;

use crate::{MAX_SHOTS, SIDES_PX};

/// Reasons why a texture cannot be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TextureError {
    /// The side is out of range or not a power of two.
    #[error("a texture's side must be a power of two from {} to {} px; got {side_px}", SIDES_PX.start(), SIDES_PX.end())]
    Side {
        /// Requested side.
        side_px: u32,
    },
    /// There is no photo, or more than [`MAX_SHOTS`].
    #[error("a texture needs 1 to {MAX_SHOTS} photos; got {found}")]
    ShotCount {
        /// Number of photos.
        found: usize,
    },
    /// The number of values differs from the number of vertices.
    #[error("{found} {what} for {expected} vertices")]
    WrongLength {
        /// Kind of values.
        what: &'static str,
        /// Number of vertices.
        expected: usize,
        /// Number of values.
        found: usize,
    },
    /// A value is infinite or NaN.
    #[error("{what} of vertex {vertex} is not finite")]
    NotFinite {
        /// Kind of values.
        what: &'static str,
        /// First such vertex.
        vertex: usize,
    },
    /// A list refers to a vertex that does not exist.
    #[error("{what} refer to vertex {vertex}, but the mesh has {vertex_count} vertices")]
    VertexOutOfRange {
        /// The list.
        what: &'static str,
        /// First such vertex.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// The mesh covers no texel: its texture coordinates have no area or lie outside 0..=1.
    #[error("the mesh covers no part of its texture")]
    NoArea,
    /// The whole mesh faces away, is hidden, or lies outside the photos.
    #[error("none of the {shots} photos shows any part of the mesh")]
    NothingSeen {
        /// Number of photos.
        shots: usize,
    },
    /// The picture cannot be created.
    #[error(transparent)]
    Photo(#[from] PhotoError),
}
