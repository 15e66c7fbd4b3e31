//! Tests of the library.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;
mod files;
#[allow(dead_code, reason = "the pictures of the golden landmarks are not used")]
#[path = "../../../landmarks/tests/support/pictures.rs"]
mod pictures;
mod remarks;
mod requests;
