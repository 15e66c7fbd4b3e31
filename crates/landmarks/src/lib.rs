//! Picture to faces: MediaPipe's face networks, run with tract.
//!
//! [`FaceFinder`] holds the two networks; [`FaceFinder::find`] takes a picture to its faces, 468 landmarks each, and
//! agrees with MediaPipe's Face Mesh in static image mode where it is asked to. The steps, each in its own module: the whole
//! picture is resampled (`warp`) for the `detector`, whose overlapping boxes are merged (`suppression`); the eyes of a
//! detection turn it into a square `region`, which is resampled for the landmark network (`mesh`). Beyond MediaPipe, and by
//! default: a `search` through turns and tiles of the picture at several sizes (`pyramid`), and a `judgement` that looks again
//! until the landmarks settle, and drops what is no face.

mod anchors;
mod attention;
mod detector;
mod error;
mod finder;
#[cfg(test)]
mod golden_steps;
mod homography;
mod judgement;
mod mesh;
mod names;
mod network;
mod operators;
mod part;
mod prelu;
mod prominence;
mod pyramid;
mod region_of_interest;
mod search;
mod suppression;
mod warp;

pub use error::LandmarksError;
pub use finder::{Face, FaceFinder, FindOptions, Search, Stage};
pub use mesh::{LANDMARK_COUNT, LandmarkNetwork};
pub use region_of_interest::RegionOfInterest;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
