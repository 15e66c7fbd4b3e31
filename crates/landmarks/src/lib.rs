//! Finds faces and their landmarks in pictures with MediaPipe's networks, run by tract.
//!
//! [`FaceFinder::find`] returns the faces of a picture with 468 landmarks each. With [`FindOptions::mediapipe`] it
//! agrees with MediaPipe's Face Mesh in static image mode. The stages are modules: `warp` resamples the whole picture
//! for the `detector`; `suppression` merges overlapping boxes; the eyes of a detection give a square, rotated region,
//! which is resampled for the landmark network (`mesh`).
//!
//! By default it goes beyond MediaPipe: `search` covers rotations and tiles of the picture at several sizes
//! (`pyramid`), and `verification` repeats the landmark network until the landmarks converge, and rejects false
//! detections.
//!
//! [`FaceFinder::follow`] follows a face through the frames of a video, starting from the previous frame's landmarks
//! (`follow`).

mod anchors;
#[cfg(test)]
#[allow(dead_code, reason = "the integration tests use the rest")]
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
mod verification;
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

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
