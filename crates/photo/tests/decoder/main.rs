//! Tests of the decoder.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod colour_profiles;
mod cut_jpegs;
mod damaged_jpegs;
mod decoding;
mod kinds;
mod lens;
mod libjpeg;
mod png_colours;
mod png_palettes;
mod refusals;
mod scaling;
#[path = "../../../../tests/seeded.rs"]
mod seeded;
mod support;
mod webp_chunks;
