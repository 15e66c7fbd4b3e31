//! The published tables, each in a file of its own.

mod canonical;
mod mirror;
mod positions;
mod procrustes;
mod tessellation;
mod uvs;

pub(crate) use canonical::CANONICAL;
pub(crate) use mirror::MIRROR;
pub(crate) use positions::POSITIONS;
pub(crate) use procrustes::PROCRUSTES;
pub(crate) use tessellation::TESSELLATION;
pub(crate) use uvs::UVS;
