//! The canonical face, and metric, coloured, textured face models from landmarks.
//!
//! The canonical face is MediaPipe's: an average head with 468 landmarks, two triangulations, exact mirror pairs and
//! named regions. "Left" and "right" are the subject's.

mod areas;
mod camera;
mod canonical;
mod card;
mod carved_eyes;
mod cheeks;
mod contours;
mod error;
mod irises;
mod measures;
mod model;
mod names;
mod observation;
mod openings;
mod photo_lens;
mod plausibility;
mod procrustes;
mod regions;
mod size;
mod symmetry;
mod tables;
mod turn;

pub use areas::Area;
pub use camera::{Camera, Pose};
pub use canonical::{
    MAX_DENSITY, Triangulation, canonical_positions_m, canonical_uvs, crowded_landmarks, opening_edges,
};
pub use card::CardCorners;
pub use carved_eyes::{CarvedEyes, Gaze};
pub use cheeks::{covered_cheek, face_width_px};
pub use contours::OVAL;
pub use error::FaceError;
pub use irises::{IRIS_COUNT, POINT_COUNT, iris_id, lids_of};
pub use measures::{Length, Measure};
pub use model::{FaceModel, LeftOut, MAX_PHOTOS, PoseFit, Reprojection, View, check_landmarks, depth_bias_m};
pub use names::{landmark_id, part_id};
pub use observation::{MAX_PICTURE_SIDE_PX, Observation};
pub use openings::{Opening, Piece, SplitFace, without_fillings};
pub use photo_lens::{DISTANCES_M, PhotoLens};
pub use plausibility::likeness;
pub use regions::Region;
pub use rosto_photo::Photo;
pub use size::{Scale, ScaleSource};
pub use symmetry::{MIDLINE, mirror_of};
pub use tables::LANDMARK_COUNT;
pub use turn::Turn;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
