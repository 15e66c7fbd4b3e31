//! A user's session: the open face, settings, selection and view, and the actions on them.
//!
//! A [`Session`] is plain data, independent of browser and GPU. Each user action is an [`Intent`]. [`Session::apply`]
//! applies an intent completely or not at all and returns what [`Changed`]. The caller then reads [`State`], [`Tick`]
//! during an edit, and the [`Stage`](rosto_stage::Stage) for the view. Intents and states are messages: they implement
//! serde and have TypeScript types.

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
mod gesture;
mod live_preview;
mod look;
mod marks;
mod message;
mod open_face;
mod panel;
mod panel_state;
mod range;
mod rows;
mod saved;
mod seeds;
mod selection;
mod session;
mod shape_part;
mod slider_influence;
mod strokes;
mod texture;
mod view;

#[cfg(test)]
extern crate self as rosto_session;

pub use changed::Changed;
pub use choice::Choice;
pub use drag::Pace;
pub use edit_options::{AnchorChoice, EditOptions, Preset, RADIUS_MM, SLIDER_MM};
pub use error::SessionError;
pub use files::{Abilities, BodyError, BodyFacts, Outcome, Report};
pub use gesture::Hovered;
pub use live_preview::LivePreview;
pub use look::Look;
pub use message::value::Value;
pub use message::{Applied, Catalogue, LightSettings, PhotoState, State, Tick};
pub use open_face::{MAX_OFFSET_M, OpenFace, PhotoEdit, PhotoFacts};
pub use panel::{
    ChoiceLook, Control, GroupLook, Held, Key, Level, MAX_LISTED, PanelDiff, Part, Phrase, Place, Tone, Widget,
};
pub use range::Range;
pub use rows::Row;
pub use saved::MAX_SHOWN_DENSITY;
pub use selection::{Selection, SelectionMode};
pub use session::{BRUSH_PX, FALLOFF_BAND, Intent, Session};
pub use shape_part::ShapePart;
pub use strokes::Strokes;
pub use texture::TextureSource;
pub use view::{Motion, Turntable, View};

/// Compiles the README's examples as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
