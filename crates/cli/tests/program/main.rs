//! Tests of the program `rosto`.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod batch;
mod camera;
mod common;
mod folders;
mod following;
mod inputs;
mod landmarks;
mod mesh;
mod meshes;
mod networks;
mod no_effect;
mod outputs;
mod paper;
mod photo;
mod photo_sets;
mod printing;
mod refusals;
mod requests;
mod resume;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
