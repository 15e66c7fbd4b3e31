//! An open surface made a closed body that can be printed: a wall of some thickness, or a relief with a flat back.
//!
//! [`Body::closed`] checks the surface and closes its openings (`front`), puts something behind it (`wall`, `flat`), and
//! lets nothing go through itself (`crossings`). [`Body::closed_or_smoothed`] rounds off what leaves no room for a wall (`softer`).
//! A body knows its volume, its size and its weight. Knows nothing of faces.

mod body;
mod crossings;
mod error;
mod filling;
mod flat;
mod front;
mod softer;
mod wall;

pub use body::{Body, Closing, PLA_G_PER_CM3};
pub use error::SolidError;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
