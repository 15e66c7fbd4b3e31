//! Bakes photos of a mesh into one picture in the mesh's texture coordinates.
//!
//! [`texture`] resamples each [`Shot`] to the texture of a [`Subject`] twice, directly and mirrored (`layer`), and uses
//! the parts of each that are visible (`depths`) and that show the mesh rather than an occluder or the background
//! (`trust`). It matches exposures where two layers overlap (`matching`), averages low frequencies and takes details
//! from the best layer (`blend`), and fills the rest from its surroundings (`filling`, `grain`). These steps work on
//! small maps (`map`), from which the texels are rendered (`draw`). The crate does not depend on faces.

mod atlas;
mod bake;
mod blend;
mod depths;
mod draw;
mod error;
mod filling;
mod grain;
mod layer;
mod limits;
mod map;
mod matching;
mod raster;
mod sampling;
mod subject;
mod trust;

pub use bake::{Texture, texture};
pub use blend::Shares;
pub use error::TextureError;
pub use limits::{MAX_SHOTS, SIDES_PX};
pub use raster::{Span, spans};
pub use subject::{Eye, Shot, Subject};

/// Tests the README's examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
