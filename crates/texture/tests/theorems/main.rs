//! What must hold for every texture, whatever the mesh and its photos.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod colours;
mod hidden;
mod raster;
mod refusals;
mod scenes;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod symmetries;
