//! The document: commands, history, undo and the project file.
//!
//! A [`Document`] is a mesh at rest and a [`History`] of commands. The displayed vertices are computed from both and
//! are not stored. An edit has three steps with different costs: [`Document::prepare`] solves for the response of the
//! chosen vertices, [`Document::preview`] moves them on each slider tick without a solve or an allocation, and
//! [`Document::commit`] adds the drag to the history as one entry.

mod command;
mod document;
mod error;
mod expression_cache;
mod expressions;
mod fading;
mod fault;
mod history;
mod influence;
mod level;
mod level_positions;
mod mirror;
pub mod paper;
mod photo_warp;
mod prepared_edit;
pub mod project;
mod rig;
mod shape;
mod slider_measures;
mod sliders;
mod spec_key;
mod stream_warp;
mod target;
mod vertex_colours;
mod whole_texture;

pub use command::{AnchorKind, Anchors, Command, Details, EditSpec, Mirror, RegionOfInfluence, Settings};
pub use document::{Document, DocumentState, MAX_ENTRIES, MAX_LABEL_CHARS, SMOOTH_DENSITY};
pub use error::StudioError;
pub use expressions::{Expression, Expressions};
pub use fading::fading;
pub use history::{Entry, EntryStatus, History, Switch};
pub use influence::InfluenceWeights;
pub use level::{CoordinateFrame, Rest};
pub use photo_warp::{DEFAULT_FALLOFF_BAND, FALLOFF_BAND_SHARES, PhotoWarp};
pub use rig::{EditsInRig, Layer, Rig};
pub use rosto_laplacian::{ConstraintKind, Operator};
pub use rosto_texture::{Shares, Texture};
pub use slider_measures::SliderAmounts;
pub use sliders::FaceSlider;
pub use stream_warp::StreamWarp;
pub use target::{Amount, EditTarget};
pub use vertex_colours::vertex_colours;
pub use whole_texture::{texture_side_px, whole_texture};

/// Compiles the README's examples as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
