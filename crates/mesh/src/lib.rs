//! Triangle meshes: topology apart from positions, adjacency, normals, subdivision, picking.
//!
//! A mesh is a [`Topology`] (which vertices are joined) beside a slice of positions (where they are), so that one
//! topology serves every edit of a face; a [`Surface`] borrows both and knows that they fit. Positions are `f64` in whatever unit the caller works in.

mod boundary;
mod error;
mod named;
mod normals;
mod pick;
#[cfg(test)]
mod shapes;
mod stencils;
mod subdivision;
mod surface;
mod topology;

pub use error::MeshError;
pub use normals::vertex_normals;
pub use pick::{Hit, Ray, pick};
pub use subdivision::{LoopSubdivision, Value};
pub use surface::Surface;
pub use topology::Topology;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
