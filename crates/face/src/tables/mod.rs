//! The published tables, each in a file of its own.

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

/// How many landmarks MediaPipe's face mesh has; a landmark's index is its vertex.
pub const LANDMARK_COUNT: usize = 468;
