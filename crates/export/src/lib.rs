//! Exporters for mesh file formats, and readers for Rosto's own files.
//!
//! An exporter is a pure function from a [`Model`] and documented options to bytes; [`Format`] lists them all.
//! Positions are in metres, in the model's frame (+Y up, +Z out of the face); `f64` is converted to `f32` here.
//! [`reopen`] and [`project::read`] read files back.

mod about;
mod colour;
mod error;
mod format;
mod glb;
mod model;
mod placed;
mod printable;
pub mod project;
mod reopen;
mod reopen_error;
mod saved;
mod sniff;
mod texture;
mod zip;

pub use about::about;
pub use colour::linear_from_srgb;
pub use error::ExportError;
pub use format::{
    Content, ExportOption, ExportedFile, Eyes, Format, JsonMesh, Units, mesh_json, obj, ply, stl, three_mf, usdz,
};
pub use glb::{GlbOptions, Material, Morph, TextureSize, glb, gltf};
pub use model::{Model, ModelEyes, Picture};
pub use printable::{
    DEPTH_MM, HEIGHT_MM, ParseHeightError, ParseSolidError, Print, PrintHeight, PrintPose, PrintedBody, SOLID_MM,
    Solid, SolidFacts,
};
pub use reopen::{Reopened, reopen};
pub use reopen_error::ReopenError;
pub use rosto_solid::SolidError;
pub use saved::{SavedEdits, SavedFace, Source};
pub use sniff::{FileKind, SNIFFED_BYTES, sniff};
pub use texture::BaseColour;
pub use zip::NamedFile;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
