//! Weights of the landmarks in a photo, by part of the face and by visibility.

use glam::DVec3;
use rosto_mesh::vertex_normals;

use super::bias::bias;
use crate::{LANDMARK_COUNT, Triangulation};

/// Cosines between normal and camera direction, below which a landmark has no weight, and above which it has full
/// weight. The network guesses hidden landmarks.
const COSINES: [f64; 2] = [0.1, 0.5];

/// Weights of the landmarks, independent of visibility.
pub(super) fn reliabilities() -> impl Iterator<Item = f64> {
    (0..LANDMARK_COUNT as u32).map(|landmark| bias(landmark).weight)
}

/// Visibility of 468 landmarks, 0 to 1; `towards` returns the direction from a point to the camera.
pub(super) fn visibility(shape_m: &[DVec3], towards: impl Fn(DVec3) -> DVec3) -> Vec<f64> {
    let normals = vertex_normals(&Triangulation::Canonical.topology(), shape_m);
    let cosines = normals.iter().zip(shape_m).map(|(normal, &position_m)| normal.dot(towards(position_m)));
    cosines.map(|cosine| ((cosine - COSINES[0]) / (COSINES[1] - COSINES[0])).clamp(0.0, 1.0)).collect()
}

/// Weights of 468 landmarks.
pub(super) fn weights(shape_m: &[DVec3], towards: impl Fn(DVec3) -> DVec3) -> Vec<f64> {
    visibility(shape_m, towards)
        .into_iter()
        .zip(reliabilities())
        .map(|(visibility, weight)| visibility * weight)
        .collect()
}
