//! Photos of a mesh to one picture in the mesh's own texture coordinates.
//!
//! [`texture`] lays each [`Shot`] out in the texture of a [`Subject`] twice, as it is and as the mirror image of its other
//! side (`layer`), and takes of each what is seen (`depths`) and is of the mesh and not before or behind it (`trust`). Light
//! is matched where two show the same (`matching`), slow colours are mixed, details come from the best (`blend`), and what
//! none shows is filled from around it (`filling`, `grain`). All of this is worked out on small maps (`map`), which the texels are
//! then drawn by (`draw`). Knows nothing of faces.

mod atlas;
mod bake;
mod between;
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
mod plan;
mod raster;
mod subject;
mod trust;

pub use bake::{Texture, texture};
pub use blend::Shares;
pub use error::TextureError;
pub use limits::{MOST_SHOTS, SIDES_PX};
pub use plan::Plan;
pub use raster::{Span, spans};
pub use subject::{Eye, Shot, Subject};

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
