//! The worker's façade: a photo's bytes in, faces and an upright picture out.
//!
//! Everything that goes wrong is thrown as an `Error` with a stable `code` and a `hint` beside its `message`. A panic
//! is a bug and traps: the page then ends the worker and starts another.

mod error;
mod found;
mod limits;
mod progress;
mod texture_maker;
mod vision;
mod warped;

pub use found::Found;
pub use limits::{check_length, check_size};
pub use texture_maker::TextureMaker;
pub use vision::Vision;
pub use warped::Warped;
