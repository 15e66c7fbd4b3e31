//! The document: commands, history, undo, project file.
//!
//! A [`Document`] is a mesh at rest and a [`History`] of commands over it; the vertices on screen follow from the two and
//! are never stored. Editing runs in three steps that cost what their names say: [`Document::hold`] takes hold of
//! vertices (one solve), [`Document::preview`] moves them (on every slider tick; no solve, no allocation), and
//! [`Document::commit`] makes the drag one entry of the history.

mod command;
mod document;
mod error;
mod follow;
mod grip;
mod history;
mod level;
mod mirror;
pub mod paper;
pub mod project;
mod shape;
mod sliders;
mod subject;

pub use command::{AnchorKind, Anchors, Command, Details, Grip, Mirror, Reach, Settings};
pub use document::{Document, MAX_DENSITY};
pub use error::StudioError;
pub use follow::Follow;
pub use history::{Entry, History, Standing, Switch};
pub use level::{Frame, Rest};
pub use rosto_laplacian::{Hold, Operator};
pub use sliders::FaceSlider;
pub use subject::{Amount, Subject};
