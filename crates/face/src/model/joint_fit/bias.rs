//! Systematic and random errors of the landmark network on turned heads, by part of the face.

use crate::LANDMARK_COUNT;
use crate::areas::Area;

/// Error statistics of a part of the face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bias {
    /// Weight: inverse variance between heads, reduced for parts that move with the expression.
    pub(super) weight: f64,
    /// Apparent outward displacement, in mm.
    outward_mm: f64,
}

/// Bias of a landmark's depth in photos of turned heads, in metres towards the camera of a frontal photo.
///
/// The network pulls landmarks towards its training data, separately in each photo. Combined photos of turned heads
/// therefore give noses that are too long and jaws that are too short.
///
/// Medians over rendered heads of known shape, of both sexes, all ages and several origins (MakeHuman, public domain),
/// turned by 20 and 30°.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`].
pub fn depth_bias_m(landmark: u32) -> f64 {
    bias(landmark).outward_mm * 1e-3
}

/// [`depth_bias_m`] of all landmarks.
pub(super) fn depth_biases_m() -> Vec<f64> {
    (0..LANDMARK_COUNT as u32).map(depth_bias_m).collect()
}

pub(super) fn bias(landmark: u32) -> Bias {
    let (weight, outward_mm) = match Area::of(landmark) {
        Area::Forehead => (0.3, -1.0),
        Area::Glabella => (1.0, 3.0),
        Area::Temple | Area::SideOfFace => (0.05, 0.0),
        Area::Brow => (0.5, 0.0),
        Area::UnderBrow => (1.0, -1.0),
        Area::UpperEyelid => (0.4, -2.0),
        Area::LowerEyelid => (0.4, -1.5),
        Area::EyeCorner => (1.0, -0.5),
        Area::UnderEye => (1.0, -1.5),
        Area::Cheekbone => (0.4, -2.5),
        Area::Cheek => (0.5, 0.5),
        Area::NoseBridge => (0.5, 5.0),
        Area::NoseSide => (0.8, 1.5),
        Area::NoseTip => (0.4, 6.0),
        Area::NoseWing => (0.5, 6.5),
        Area::Nostril => (0.4, 5.0),
        Area::Philtrum => (0.6, 1.5),
        Area::UpperLip => (0.3, -1.0),
        Area::LowerLip | Area::MouthCorner => (0.3, -0.5),
        Area::ChinCrease => (0.4, -2.5),
        Area::SmileLine => (0.4, -1.5),
        Area::Chin => (0.4, -2.0),
        Area::Jaw => (0.2, -6.5),
    };
    Bias { weight, outward_mm }
}
