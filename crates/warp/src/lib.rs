//! A picture that follows points in it, without a seam: what is around the points gives way smoothly, up to a border where
//! nothing moves.
//!
//! [`Warp`] lays a triangulation over a picture (`layout`): the points themselves, and a lattice around and between them.
//! Wherever the points go, the rest follows with value and slope zero at the border and no bi-Laplacian between, and where a
//! triangle would fold, the way is shortened (`folds`, after `coarse`). [`drawn`] draws the picture so. [`leading`] tells
//! which points of a surface can lead what is in its picture: those that are [`seen()`], and not beside another sheet of it.
//! Knows nothing of faces.

mod cells;
mod coarse;
mod draw;
mod error;
mod folds;
mod layout;
mod seen;
mod surfaces;
mod warp;

pub use draw::drawn;
pub use error::WarpError;
pub use layout::{Dab, FALLOFF_BAND_SHARES, Subject};
pub use seen::seen;
pub use surfaces::leading;
pub use warp::{Warp, WarpMesh};

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
