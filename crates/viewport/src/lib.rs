//! Draws a mesh with wgpu.
//!
//! A `rosto_stage::Stage`, owned by the caller, describes the view. A [`Viewport`] holds a mesh in GPU memory and draws
//! a stage on a canvas or into a picture that is read back, only after changes. Positions are metres in the model's
//! frame, +Y up, +Z out of the face; px are device pixels from the top left.

mod error;
mod error_scopes;
mod frame;
mod gpu;
mod mesh;
mod passes;
mod photo_layer;
mod picture;
mod pipelines;
mod shaders;
mod snapshot;
mod target;
mod vertex;
mod vertex_data;
mod viewport;

pub use error::ViewportError;
pub use gpu::{Backend, Gpu};
pub use mesh::MeshInput;
pub use photo_layer::PhotoLayerInput;
pub use picture::PictureOnGpu;
pub use snapshot::Snapshot;
pub use target::Target;
pub use viewport::Viewport;

/// Tests the README's examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
