//! What is seen of a mesh and how: camera, light, look, marks, the gizmo.
//!
//! A [`Stage`] is plain data and knows no GPU, so that whoever decides what is shown can be tried without one. Whoever
//! draws it asks [`Stage::advance`] whether to, and reads [`Stage::uniforms`] and [`Stage::mark_words`]. Positions are
//! metres in the model's frame, +Y up, +Z out of the face; px are device pixels from the top left.

mod camera;
mod colour;
mod frame;
mod light;
mod look;
mod markers;
mod stage;

pub use camera::{Camera, Glide, NamedView};
pub use colour::Srgb;
pub use frame::Frame;
pub use light::Light;
pub use look::{Background, Dots, Look, MirrorPlane, Paint, Palette, Theme, Wireframe};
pub use markers::{Axis, Mark, MarkKind, Pointer};
pub use stage::{Stage, Step};
