//! What is seen of a mesh and how: camera, lens, light, look, marks, the gizmo.
//!
//! A [`Stage`] is plain data and knows no GPU, so that whoever decides what is shown can be tried without one. Whoever
//! draws it asks [`Stage::advance`] whether to, and reads [`Stage::uniforms`] and [`Stage::mark_words`]. Positions are
//! metres in the model's frame, +Y up, +Z out of the face; px are device pixels from the top left.

mod camera;
mod colour;
mod lens;
mod light;
mod markers;
mod picture_plane;
mod render_settings;
mod stage;

pub use camera::{Camera, Glide, NamedView, Sides};
pub use colour::Srgb;
pub use lens::{Lens, Pinhole};
pub use light::Light;
pub use markers::{Axis, Mark, MarkKind, Pointer};
pub use picture_plane::PicturePlane;
pub use render_settings::{
    Background, Dots, Palette, PictureLight, RenderSettings, Scene, ShadingMode, Surface, Theme, Visibility,
};
pub use stage::{FrameUniforms, Stage, Step};

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
