//! Closes an open surface to a printable body: a wall of constant thickness, or a relief with a flat back.
//!
//! [`Body::closed`] validates the surface and fills its openings (`front`), adds a back (`wall`, `flat`), and prevents
//! self-intersections (`crossings`). [`Body::closed_or_smoothed`] smooths folds that leave no room for a wall
//! (`smoothed`), and [`Body::carved`] carves details into the front (`carved`). A body knows its volume, size, printed mass, wall
//! thickness and overhangs. The crate is independent of faces.

mod body;
mod carved;
mod crossings;
mod error;
mod filling;
mod flat;
mod front;
mod smoothed;
mod wall;

pub use body::{Body, Closing, PLA_G_PER_CM3};
pub use carved::Carving;
pub use error::SolidError;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
