//! The document: commands, history, undo, project file.
//!
//! A [`Document`] is a mesh at rest and a [`History`] of commands over it; the vertices on screen follow from the two and
//! are never stored. Editing runs in three steps that cost what their names say: [`Document::prepare`] takes hold of
//! vertices (one solve), [`Document::preview`] moves them (on every slider tick; no solve, no allocation), and
//! [`Document::commit`] makes the drag one entry of the history.

mod command;
mod document;
mod error;
mod expressed;
mod expressions;
mod fading;
mod fault;
mod history;
mod in_photo;
mod influence;
mod level;
mod level_positions;
mod mirror;
pub mod paper;
mod prepared_edit;
pub mod project;
mod rig;
mod sliders;
mod stream_warp;
mod target;
mod whole_texture;

pub use command::{AnchorKind, Anchors, Command, Details, EditSpec, Mirror, RegionOfInfluence, Settings};
pub use document::{Document, DocumentState, SMOOTH_DENSITY};
pub use error::StudioError;
pub use expressions::{Expression, Expressions};
pub use fading::fading;
pub use history::{Entry, EntryStatus, History, Switch};
pub use in_photo::{DEFAULT_FALLOFF_BAND, FALLOFF_BAND_SHARES, InPhoto};
pub use influence::InfluenceWeights;
pub use level::{CoordinateFrame, Rest};
pub use rig::{EditsInRig, Layer, Rig};
pub use rosto_laplacian::{ConstraintKind, Operator};
pub use rosto_texture::{Shares, Texture};
pub use sliders::FaceSlider;
pub use stream_warp::StreamWarp;
pub use target::{Amount, EditTarget};
pub use whole_texture::{Shot, texture_plan, texture_side_px, whole_texture, whole_texture_of};

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
