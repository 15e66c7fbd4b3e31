//! The wgpu view of a mesh: ways to paint it, marks on it, pictures of it.
//!
//! A `rosto_stage::Stage` says what is seen and how; it is the caller's. A [`Viewport`] keeps a mesh in the GPU's memory
//! and draws a stage, only when something changed, on a canvas or into a picture that is read back. Positions are metres
//! in the model's frame, +Y up, +Z out of the face; px are device pixels from the top left.

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

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
