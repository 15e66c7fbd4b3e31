//! Tests of the file formats.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod archive;
mod common;
mod glb;
mod mesh_json;
mod other_formats;
mod packages;
mod project;
mod reopen;
mod several;
mod validator;
