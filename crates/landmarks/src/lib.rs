//! Picture to faces: MediaPipe's face networks, run with tract.
//!
//! [`FaceFinder`] holds two networks; [`FaceFinder::find`] takes a picture to its faces, 468 landmarks each, and
//! agrees with MediaPipe's Face Mesh in static image mode where it is asked to. The steps, each in its own module: the whole
//! picture is resampled (`warp`) for the `detector`, whose overlapping boxes are merged (`suppression`); the eyes of a
//! detection turn it into a square `region`, which is resampled for the landmark network (`mesh`). Beyond MediaPipe, and by
//! default: a `search` through turns and tiles of the picture at several sizes (`pyramid`), and a `verification` that looks again
//! until the landmarks settle, and drops what is no face. [`FaceFinder::follow`] takes the frames of a video one by one and looks
//! where the face was in the frame before (`follow`).

mod anchors;
#[cfg(test)]
#[allow(dead_code, reason = "the tests of the whole use the rest")]
#[path = "../tests/support/assets.rs"]
mod assets;
mod attention;
mod constants;
mod detection;
mod detector;
mod error;
mod face;
mod finder;
mod follow;
#[cfg(test)]
mod golden_steps;
mod graph;
mod homography;
mod verification;
mod layers;
mod mesh;
mod network;
mod outline;
mod part;
mod prominence;
mod pyramid;
mod raw_mesh;
mod region_of_interest;
mod search;
#[cfg(test)]
#[path = "../../../tests/seeded.rs"]
mod seeded;
mod suppression;
mod warp;

pub use error::LandmarksError;
pub use face::Face;
pub use finder::{FaceFinder, FindOptions, FoundFaces, Search, Stage};
pub use follow::{FollowedFace, Follower, Origin};
pub use mesh::LandmarkNetwork;
#[cfg(feature = "bench")]
pub use network::Network;
pub use raw_mesh::LANDMARK_COUNT;
pub use region_of_interest::RegionOfInterest;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
