//! What the network makes of a head that is turned: some parts it draws further out than they are, and some are never twice in
//! the same place.

use crate::LANDMARK_COUNT;
use crate::areas::Area;

/// How a part of the face is found in photos of a turned head.
#[derive(Debug, Clone, Copy)]
pub(super) struct Habit {
    /// How much it counts: one over the square of how much it is off between heads, and less for what moves with the
    /// expression.
    pub(super) steadiness: f64,
    /// How much further out of the face than it is, in mm, it seems to lie.
    drawn_out_mm: f64,
}

/// How much nearer to the camera of a photo that looks at the face a landmark seems to lie than it does, in metres, where it is
/// found from the side: photos of turned heads, put together, make noses too long and jaws too short by so much, since the
/// network draws each towards what it has learnt, and not towards one shape.
///
/// Measured on rendered heads of known shape, of both sexes, all ages and several origins (MakeHuman's, which are in the public
/// domain), turned by 20 and 30°: the median over heads, by the part of the face.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`].
pub fn drawn_out_m(landmark: u32) -> f64 {
    habit(landmark).drawn_out_mm * 1e-3
}

/// [`drawn_out_m`] of all landmarks.
pub(super) fn all_drawn_out_m() -> Vec<f64> {
    (0..LANDMARK_COUNT as u32).map(drawn_out_m).collect()
}

pub(super) fn habit(landmark: u32) -> Habit {
    let (steadiness, drawn_out_mm) = match Area::of(landmark) {
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
    Habit { steadiness, drawn_out_mm }
}
