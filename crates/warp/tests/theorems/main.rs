//! Properties that hold for any warp.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod borders;
mod drawing;
mod folds;
mod refusals;
mod scenes;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod seeing;
mod strip;
mod symmetries;
