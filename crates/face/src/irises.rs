//! Iris points, found by a separate network, and the centres of the eyes.

use glam::DVec3;

use crate::LANDMARK_COUNT;

/// Number of points of both irises.
pub const IRIS_COUNT: usize = 10;

/// Number of landmarks and iris points.
pub const POINT_COUNT: usize = LANDMARK_COUNT + IRIS_COUNT;

/// Lid edges of the right and the left eye.
pub(crate) const LIDS: [[u16; 16]; 2] = [
    [33, 7, 163, 144, 145, 153, 154, 155, 133, 246, 161, 160, 159, 158, 157, 173],
    [263, 249, 390, 373, 374, 380, 381, 382, 362, 466, 388, 387, 386, 385, 384, 398],
];

/// Middle of the upper and the lower lid, of the right and the left eye.
pub(crate) const MIDDLE_OF_LIDS: [[usize; 2]; 2] = [[159, 145], [386, 374]];

/// Points of one iris: the centre and four on its border.
pub(crate) const POINTS_OF_AN_IRIS: usize = IRIS_COUNT / 2;

/// Landmarks in the middle of the upper and the lower lid around an iris point, which is counted from 0.
///
/// # Panics
/// If `point` is not below [`IRIS_COUNT`].
pub fn lids_of(point: usize) -> [usize; 2] {
    MIDDLE_OF_LIDS[point / POINTS_OF_AN_IRIS]
}

/// Identifier of an iris point, such as `left-iris-top`. The eye is named from the subject's view, the position on the
/// iris from the picture's. The right iris comes first.
///
/// # Panics
/// If `point` is not below [`IRIS_COUNT`].
pub fn iris_id(point: usize) -> String {
    const PARTS: [&str; POINTS_OF_AN_IRIS] = ["middle", "picture-right", "top", "picture-left", "bottom"];
    assert!(point < IRIS_COUNT, "point {point} of {IRIS_COUNT}");
    let side = if point < PARTS.len() { "right" } else { "left" };
    format!("{side}-iris-{}", PARTS[point % PARTS.len()])
}

/// Centres of the right and the left eye: the mean of the lid edges, which does not move with the gaze.
pub(crate) fn eye_centres(positions: &[DVec3]) -> [DVec3; 2] {
    LIDS.map(|lids| lids.iter().map(|&at| positions[usize::from(at)]).sum::<DVec3>() / lids.len() as f64)
}
