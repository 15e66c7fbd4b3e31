//! Corrects the shape of a turned head: the network draws landmarks towards its training data, more so with the turn,
//! and guesses those on the hidden side.

use std::f64::consts::FRAC_PI_6;

use glam::DVec3;
use rosto_mesh::vertex_normals;

use crate::areas::Area;
use crate::camera::CanonicalShape;
use crate::{FaceError, LANDMARK_COUNT, Triangulation, mirror_of};

/// Turns beyond this one are corrected as this one, in units of 30°.
const MAX_TURN: f64 = 1.3;

/// Share of the difference from its mirror image that an equally visible pair of landmarks loses.
const SYMMETRY: f64 = 0.5;
/// Visibility of a hidden landmark, relative to one that faces the camera.
const MIN_VISIBILITY: f64 = 0.05;

/// Cosines between normal and view direction: below the first a landmark is a guess that leaves its ray, above the
/// second it stays on it.
const COSINES: [f64; 2] = [0.2, 0.5];
/// Smallest cosine with which a displacement along the normal is converted to one along the ray.
const MIN_COSINE: f64 = 0.3;

/// Outward displacement in mm that corrects a part of a face turned by 30°, on the near and on the far side.
///
/// For each head of known shape, differences between its turned and its frontal photos; means over fifteen synthetic
/// heads, between which they vary by 0.1 to 0.2. Their mean shape does not enter (`tests/reference/heads.py`).
fn correction_mm(area: Area) -> [f64; 2] {
    match area {
        Area::Brow => [0.8, -0.2],
        Area::Cheek => [1.2, -0.5],
        Area::Cheekbone => [1.6, 0.2],
        Area::Chin => [0.6, 0.0],
        Area::ChinCrease => [0.4, -0.2],
        Area::EyeCorner => [0.0, 0.1],
        Area::Forehead => [0.4, 0.2],
        Area::Glabella => [-0.5, -0.5],
        Area::Jaw => [0.5, 0.4],
        Area::LowerEyelid => [-0.1, 0.2],
        Area::LowerLip => [0.0, 0.6],
        Area::MouthCorner => [0.3, 0.3],
        Area::NoseBridge => [-1.0, -0.2],
        Area::NoseSide => [-1.5, -0.5],
        Area::NoseTip => [-0.9, -0.2],
        Area::NoseWing => [-0.8, -1.5],
        Area::Nostril => [-0.1, -0.5],
        Area::Philtrum => [-0.9, -1.4],
        Area::SideOfFace => [-1.4, 2.2],
        Area::SmileLine => [1.0, -0.7],
        Area::Temple => [-0.8, 3.1],
        Area::UnderBrow => [0.9, -1.4],
        Area::UnderEye => [0.8, 0.1],
        Area::UpperEyelid => [0.3, -0.2],
        Area::UpperLip => [-0.5, -0.4],
    }
}

/// Moves 468 landmarks, in the frame and size of the canonical face, to where they are on the head. `eye_m` is the
/// camera.
///
/// Systematic errors are removed along the normals, and each landmark is averaged with its mirror partner, weighted by
/// how much each faces the camera. Landmarks that face it move along their rays only.
///
/// # Errors
/// [`FaceError::Degenerate`] if a position is not finite.
pub(super) fn corrected(found_m: &[DVec3], eye_m: DVec3, shape: &CanonicalShape) -> Result<Vec<DVec3>, FaceError> {
    let middle_m = found_m.iter().sum::<DVec3>() / found_m.len() as f64;
    let corrections_m = corrections_m(eye_m - middle_m, shape)?;
    let normals = vertex_normals(&Triangulation::Canonical.topology(), found_m);
    let rays: Vec<DVec3> = found_m.iter().map(|&position_m| (eye_m - position_m).normalize()).collect();
    let cosines: Vec<f64> = normals.iter().zip(&rays).map(|(normal, ray)| normal.dot(*ray)).collect();
    let outward = found_m.iter().zip(&normals).zip(corrections_m);
    let unbiased_m: Vec<DVec3> = outward.map(|((&found_m, &normal), by_m)| found_m + normal * by_m).collect();
    let symmetric_m = symmetric(&unbiased_m, &cosines);
    let moved = (0..found_m.len()).map(|landmark| {
        let by_m = symmetric_m[landmark] - found_m[landmark];
        let cosine = cosines[landmark];
        let along_ray_m = rays[landmark] * (normals[landmark].dot(by_m) / cosine.max(MIN_COSINE));
        let facing = ((cosine - COSINES[0]) / (COSINES[1] - COSINES[0])).clamp(0.0, 1.0);
        found_m[landmark] + by_m.lerp(along_ray_m, facing)
    });
    Ok(moved.collect())
}

/// Outward displacement of each landmark for a camera in direction `to_camera` of the model's frame, in m.
fn corrections_m(to_camera: DVec3, shape: &CanonicalShape) -> Result<Vec<f64>, FaceError> {
    // The camera of a head turned to its left is on its right, at negative x.
    let turn = ((-to_camera.x).atan2(to_camera.z) / FRAC_PI_6).clamp(-MAX_TURN, MAX_TURN);
    let correction_m = |landmark: u32| {
        let [near_mm, far_mm] = correction_mm(Area::of(landmark));
        let side = match mirror_of(landmark).cmp(&landmark) {
            std::cmp::Ordering::Greater => 1.0,
            std::cmp::Ordering::Equal => 0.0,
            std::cmp::Ordering::Less => -1.0,
        };
        1e-3 * (side * turn * (near_mm - far_mm) + turn * turn * (near_mm + far_mm)) / 2.0
    };
    shape.faired(&(0..LANDMARK_COUNT as u32).map(correction_m).collect::<Vec<f64>>())
}

/// The landmarks, drawn to the mirror images of their partners; more so if the partner faces the camera and they do
/// not.
fn symmetric(positions_m: &[DVec3], cosines: &[f64]) -> Vec<DVec3> {
    const MIRROR: DVec3 = DVec3::new(-1.0, 1.0, 1.0);
    let visibility = |landmark: usize| cosines[landmark].max(MIN_VISIBILITY);
    let drawn = positions_m.iter().enumerate().map(|(landmark, &position_m)| {
        let partner = mirror_of(landmark as u32) as usize;
        let share = SYMMETRY * visibility(partner) / (visibility(landmark) + visibility(partner));
        position_m.lerp(positions_m[partner] * MIRROR, share)
    });
    drawn.collect()
}
