//! Tests of the camera and the face.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod camera;
mod card;
mod carved_eyes;
mod cheeks;
mod common;
mod model;
mod observation;
mod openings;
#[allow(dead_code, reason = "the pictures of the golden landmarks are not used")]
#[path = "../../../landmarks/tests/support/pictures.rs"]
mod pictures;
mod projection;
mod regions;
mod several;
mod tables;
