//! Façade of the worker: takes a photo's bytes and returns faces and an upright picture.
//!
//! Errors are thrown as `Error` with a stable `code`, a `hint` and a `message`. A panic is a bug and traps; the page
//! then restarts the worker.

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
