//! Picture to faces: MediaPipe's face networks, run with tract.
//!
//! [`FaceFinder`] holds the two networks; [`FaceFinder::find`] takes a picture to its faces, 468 landmarks each, and
//! agrees with MediaPipe's Face Mesh in static image mode. The steps, each in its own module: the whole picture is
//! resampled (`warp`) for the `detector`, whose overlapping boxes are merged (`suppression`); the eyes of a detection
//! turn it into a square `region`, which is resampled for the landmark network (`mesh`). Beyond MediaPipe, as options:
//! a `search` that finds faces upside down and small ones, and a second pass that steadies the landmarks.

mod anchors;
#[cfg(test)]
#[path = "../tests/support/assets.rs"]
mod assets;
mod constants;
mod detector;
mod error;
mod finder;
#[cfg(test)]
mod golden_steps;
mod graph;
mod homography;
mod mesh;

mod layers;
mod network;

mod region_of_interest;
mod search;
#[cfg(test)]
#[path = "../../../tests/seeded.rs"]
mod seeded;
mod suppression;
mod warp;

pub use error::LandmarksError;
pub use finder::{Face, FaceFinder, FindOptions, Passes, Search, Stage};
pub use mesh::LANDMARK_COUNT;
#[cfg(feature = "bench")]
pub use network::Network;
pub use region_of_interest::RegionOfInterest;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
