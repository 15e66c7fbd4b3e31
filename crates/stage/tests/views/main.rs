//! Tests of the stage.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod camera;
mod camera_stream;
mod lenses;
mod picking;
