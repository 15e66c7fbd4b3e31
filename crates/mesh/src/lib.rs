//! Triangle meshes: topology, adjacency, normals, subdivision and picking.
//!
//! A [`Topology`] is stored apart from the positions, so that one topology serves many edits of a mesh. A [`Surface`]
//! borrows both and checks that they match. Positions are `f64` in the caller's unit.

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
pub use named::Named;
pub use normals::vertex_normals;
pub use pick::{Hit, Ray, pick};
pub use subdivision::{LoopSubdivision, Value};
pub use surface::Surface;
pub use topology::Topology;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
