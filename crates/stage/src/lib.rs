//! View of a mesh, without a GPU: camera, lens, light, render settings, marks and gizmo.
//!
//! A [`Stage`] is plain data, so that its logic can be tested without a GPU. A renderer calls [`Stage::advance`] to
//! find out whether to draw, then reads [`Stage::uniforms`] and [`Stage::mark_words`]. Positions are metres in the
//! model's frame, +Y up, +Z out of the face; px are device pixels from the top left.

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

/// Tests the README's examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
