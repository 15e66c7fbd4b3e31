//! One pure function for each file format: model to bytes. And two back: [`reopen`], and [`project`] both ways.
//!
//! Every exporter takes a [`Model`] and documented options and returns the file whole. Positions are metres in the
//! model's frame (+Y up, +Z out of the face); `f64` becomes `f32` here, and not before.

mod colour;
mod error;
mod glb;
mod mesh_json;
mod model;
mod obj;
mod ply;
pub mod project;
mod reopen;
mod sniff;
mod stl;

pub use colour::linear_from_srgb;
pub use error::ExportError;
pub use glb::{BaseColour, GlbOptions, Material, Morph, Source, glb, gltf};
pub use mesh_json::{JsonMesh, mesh_json};
pub use model::Model;
pub use obj::obj;
pub use ply::ply;
pub use reopen::{Painted, PlacedTexture, ReopenError, Reopened, reopen};
pub use sniff::{FileKind, SNIFFED_BYTES, sniff};
pub use stl::stl;
