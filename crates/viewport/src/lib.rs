//! The wgpu view of a mesh: camera, light, shading modes, marks, picking.
//!
//! A [`Stage`] says what is seen and how; it is plain data and knows no GPU. A [`Viewport`] keeps a mesh in the GPU's
//! memory and draws the stage, only when something changed, on a canvas or into a picture that is read back. Positions
//! are metres in the model's frame, +Y up, +Z out of the face; px are device pixels from the top left.

mod camera;
mod colour;
mod error;
mod frame;
mod gpu;
mod light;
mod look;
mod markers;
mod mesh;
mod passes;
mod photo;
mod pipelines;
mod shaders;
mod shape;
mod snapshot;
mod stage;
mod target;
mod vertex_data;
mod viewport;

pub use camera::{Camera, Glide, NamedView};
pub use colour::Srgb;
pub use error::ViewportError;
pub use gpu::{Backend, Gpu};
pub use light::Light;
pub use look::{Background, Dots, Look, MirrorPlane, Paint, Theme, Wireframe};
pub use markers::{Axis, Mark, MarkKind, Pointer};
pub use mesh::MeshInput;
pub use photo::PictureOnGpu;
pub use snapshot::Snapshot;
pub use stage::Stage;
pub use target::Target;
pub use viewport::Viewport;
