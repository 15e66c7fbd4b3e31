//! How much a landmark of a photo counts beside those of others: by its part of the face, and by how it is turned.

use glam::DVec3;
use rosto_mesh::vertex_normals;

use super::habits::habit;
use crate::{LANDMARK_COUNT, Triangulation};

/// Turned away from the camera by so much, as the cosine, a landmark counts for nothing, and from the second on in full: what
/// cannot be seen, the network guesses.
const TURNED: [f64; 2] = [0.1, 0.5];

/// How much each landmark counts whichever way it is turned.
pub(super) fn steady() -> impl Iterator<Item = f64> {
    (0..LANDMARK_COUNT as u32).map(|landmark| habit(landmark).steadiness)
}

/// How much each of 468 landmarks is seen, 0 to 1, where `towards` tells the way from a place to the camera.
pub(super) fn visibility(shape_m: &[DVec3], towards: impl Fn(DVec3) -> DVec3) -> Vec<f64> {
    let normals = vertex_normals(&Triangulation::Canonical.topology(), shape_m);
    let turned = normals.iter().zip(shape_m).map(|(normal, &place_m)| normal.dot(towards(place_m)));
    turned.map(|cosine| ((cosine - TURNED[0]) / (TURNED[1] - TURNED[0])).clamp(0.0, 1.0)).collect()
}

/// How much each of 468 landmarks counts.
pub(super) fn trust(shape_m: &[DVec3], towards: impl Fn(DVec3) -> DVec3) -> Vec<f64> {
    visibility(shape_m, towards).into_iter().zip(steady()).map(|(seen, steady)| seen * steady).collect()
}
