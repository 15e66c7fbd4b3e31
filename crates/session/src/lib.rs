//! A visitor's session: what is open, chosen, selected and seen, and everything that can be done with it.
//!
//! A [`Session`] is plain data and knows no browser and no GPU. Whatever a visitor can want is an [`Intent`];
//! [`Session::apply`] carries it out whole or not at all, and tells what has [`Changed`]. Who shows it reads [`State`] then,
//! [`Tick`] while an edit is in progress, and the [`Stage`](rosto_stage::Stage) for what is seen.

mod changed;
mod choice;
mod choices;
mod drag;
mod error;
#[cfg(test)]
#[path = "../tests/properties/faces.rs"]
#[allow(dead_code, reason = "the visitors use the others")]
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
mod preferences;
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
pub use choices::{AnchorChoice, Choices, Preset, RADIUS_MM, Range, SLIDER_MM};
pub use drag::Pace;
pub use error::SessionError;
pub use files::{EditsAs, ExpressionsAs, FileOptions, plain_formats, printed_formats};
pub use further_photo::FurtherPhoto;
pub use gesture::Under;
pub use incoming::{DENSEST_SHOWN, Incoming, MOST_ENTRIES, Work};
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

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
