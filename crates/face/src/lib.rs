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
mod openings;
mod photo_lens;
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
pub use contours::OVAL;
pub use error::FaceError;
pub use irises::{IRIS_COUNT, POINT_COUNT, iris_id, lids_of};
pub use measures::Measure;
pub use model::{
    FaceInput, FaceModel, LeftOut, MOST_PHOTOS, Reprojection, PoseFit, View, check_landmarks, drawn_out_m,
};
pub use names::{landmark_id, part_id};
pub use openings::{Opening, Parted, Piece, without_fillings};
pub use photo_lens::{DISTANCES_M, PhotoLens};
pub use regions::Region;
pub use rosto_photo::Photo;
pub use size::{Scale, ScaleSource};
pub use symmetry::{MIDLINE, mirror_of};
pub use tables::LANDMARK_COUNT;
pub use turn::Turn;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
