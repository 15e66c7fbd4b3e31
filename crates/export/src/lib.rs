//! One pure function for each file format: model to bytes, with a table of them all ([`Format`]). And two back: [`reopen`], and [`project`] both ways.
//!
//! Every exporter takes a [`Model`] and documented options and returns the file whole. Positions are metres in the
//! model's frame (+Y up, +Z out of the face); `f64` becomes `f32` here, and not before.

mod about;
mod colour;
mod error;
mod format;
mod glb;
mod model;
mod printable;
pub mod project;
mod reopen;
mod sniff;
mod texture;
mod zip;

pub use about::about;
pub use colour::linear_from_srgb;
pub use error::ExportError;
pub use format::{
    Choosable, Content, Eyes, Format, JsonMesh, Units, ExportedFile, mesh_json, obj, ply, stl, three_mf, usdz,
};
pub use glb::{GlbOptions, Material, Morph, Source, TextureSize, glb, gltf};
pub use model::{Model, Picture};
pub use printable::{NoSolid, SOLID_MM, Solid, SolidFacts};
pub use reopen::{Further, FurtherPhoto, Painted, PlacedTexture, ReopenError, Reopened, reopen};
pub use rosto_solid::{PLA_G_PER_CM3, SolidError};
pub use sniff::{FileKind, SNIFFED_BYTES, sniff};
pub use texture::BaseColour;
pub use zip::NamedFile;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
