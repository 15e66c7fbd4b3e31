//! A user's session: the open face, settings, selection and view, and the actions on them.
//!
//! A [`Session`] is plain data, independent of browser and GPU. Each user action is an [`Intent`]. [`Session::apply`]
//! applies an intent completely or not at all and returns what [`Changed`]. The caller then reads [`State`], [`Tick`]
//! during an edit, and the [`Stage`](rosto_stage::Stage) for the view.

mod changed;
mod choice;
mod drag;
mod edit_options;
mod error;
#[cfg(test)]
#[path = "../tests/properties/faces.rs"]
#[allow(dead_code, reason = "the property tests use the other items")]
mod faces;
mod files;
mod further_photo;
mod gesture;
mod incoming;
mod intent;
mod live_preview;
mod marks;
mod names;
mod open_face;
mod rows;
mod seeds;
mod selection;
mod session;
mod slider_influence;
mod state;
mod strokes;
mod texture;
mod view;

#[cfg(test)]
extern crate self as rosto_session;

pub use changed::Changed;
pub use choice::Choice;
pub use drag::Pace;
pub use edit_options::{AnchorChoice, EditOptions, Preset, RADIUS_MM, Range, SLIDER_MM};
pub use error::SessionError;
pub use files::{EditsAs, ExpressionsAs, FileOptions, plain_formats, printed_formats};
pub use further_photo::FurtherPhoto;
pub use gesture::Hovered;
pub use incoming::{Incoming, MAX_ENTRIES, MAX_SHOWN_DENSITY, Work};
pub use intent::Intent;
pub use live_preview::LivePreview;
pub use open_face::{MAX_OFFSET_M, OpenFace, PhotoEdit, PhotoFacts};
pub use rows::Row;
pub use selection::{Selection, SelectionMode};
pub use session::{BRUSH_PX, Session};
pub use state::{FaceState, State, Tick};
pub use strokes::Strokes;
pub use texture::TextureSource;
pub use view::{Motion, Turntable, View};

/// Compiles the README's examples as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
