//! Published tables, one per file.

mod canonical;
mod positions;
mod procrustes;
mod tessellation;
mod uvs;

pub(crate) use canonical::CANONICAL;
pub(crate) use positions::POSITIONS;
pub(crate) use procrustes::PROCRUSTES;
pub(crate) use tessellation::TESSELLATION;
pub(crate) use uvs::UVS;

/// Number of landmarks of MediaPipe's face mesh; a landmark's index is its vertex.
pub const LANDMARK_COUNT: usize = 468;
