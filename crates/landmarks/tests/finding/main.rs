//! Tests of finding and following faces.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod beyond_mediapipe;
mod damaged_networks;
mod following;
mod golden_landmarks;
#[path = "../support/mod.rs"]
mod support;
