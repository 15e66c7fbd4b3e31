//! The canonical face, and landmarks to a metric, coloured, textured model.
//!
//! The canonical face is MediaPipe's: an average head of 468 landmarks with two triangulations, exact left-right pairs
//! and named regions. "Left" and "right" are the subject's throughout.

mod areas;
mod camera;
mod canonical;
mod contours;
mod error;
mod irises;
mod measures;
mod model;
mod names;
mod photo_lens;
mod procrustes;
mod regions;
mod size;
mod symmetry;
mod tables;

pub use camera::{Camera, Pose};
pub use canonical::{LANDMARK_COUNT, Triangulation, canonical_positions_m, canonical_uvs, without_fillings};
pub use contours::oval;
pub use error::FaceError;
pub use irises::{IRIS_COUNT, POINT_COUNT, iris_id, lids_of};
pub use measures::Measure;
pub use model::{FaceInput, FaceModel, Sighting, check_landmarks};
pub use names::{has_anatomical_name, landmark_id, part_id};
pub use photo_lens::{DISTANCES_M, PhotoLens};
pub use regions::Region;
pub use rosto_photo::Photo;
pub use size::{Scale, ScaleSource};
pub use symmetry::{midline, mirror_of, mirror_pairs};

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
