//! Warps a picture so that it follows given points without a visible seam. The displacement fades out smoothly around
//! the points, up to a border beyond which nothing moves.
//!
//! [`Warp`] triangulates the picture (`layout`): the points, a lattice around and between them, and the border. Around
//! the points, the displacement is a thin plate under tension, with value and slope zero at the border; the tension
//! makes a strip next to the points nearly rigid. Offsets are reduced to keep triangles from folding (`folds`,
//! `coarse`). [`drawn`] renders the warped picture. [`leading`] selects the vertices of a surface that can lead a warp:
//! those that are [`seen()`] and not close to another part of the surface.
//! The crate does not depend on faces.

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
pub use layout::{Dab, FALLOFF_BAND_SHARES, MAX_STRIP_SHARE, Subject};
pub use seen::seen;
pub use surfaces::leading;
pub use warp::{Warp, WarpMesh};

/// Tests the README's examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
