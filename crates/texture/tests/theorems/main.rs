//! Properties that hold for any texture.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod colours;
mod hidden;
mod raster;
mod refusals;
mod scenes;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod symmetries;
