//! The irises that a finer network finds, and the middles of the eyes.

use glam::DVec3;

use crate::LANDMARK_COUNT;

/// Points of both irises.
pub const IRIS_COUNT: usize = 10;

/// Landmarks and irises together.
pub const POINT_COUNT: usize = LANDMARK_COUNT + IRIS_COUNT;

/// The border of the lids of the right and of the left eye.
pub(crate) const LIDS: [[u16; 16]; 2] = [
    [33, 7, 163, 144, 145, 153, 154, 155, 133, 246, 161, 160, 159, 158, 157, 173],
    [263, 249, 390, 373, 374, 380, 381, 382, 362, 466, 388, 387, 386, 385, 384, 398],
];

/// Upper and lower lid above and below the middle of the right and of the left eye.
pub(crate) const MIDDLE_OF_LIDS: [[usize; 2]; 2] = [[159, 145], [386, 374]];

/// Points of one iris: its middle, and four on its border.
pub(crate) const POINTS_OF_AN_IRIS: usize = IRIS_COUNT / 2;

/// The landmarks in the middle of the upper and the lower lid around a point of the irises, counted from 0.
///
/// # Panics
/// If `point` is not below [`IRIS_COUNT`].
pub fn lids_of(point: usize) -> [usize; 2] {
    MIDDLE_OF_LIDS[point / POINTS_OF_AN_IRIS]
}

/// The name for files and programs of a point of an iris, such as `left-iris-top`; sides are the subject's, but for the
/// points' own, which are the picture's. The right iris comes first.
///
/// # Panics
/// If `point` is not below [`IRIS_COUNT`].
pub fn iris_id(point: usize) -> String {
    const PARTS: [&str; POINTS_OF_AN_IRIS] = ["middle", "picture-right", "top", "picture-left", "bottom"];
    assert!(point < IRIS_COUNT, "point {point} of {IRIS_COUNT}");
    let side = if point < PARTS.len() { "right" } else { "left" };
    format!("{side}-iris-{}", PARTS[point % PARTS.len()])
}

/// The middles of the right and the left eye: the mean of the border of their lids, which stays when the gaze wanders.
pub(crate) fn eye_centres(positions: &[DVec3]) -> [DVec3; 2] {
    LIDS.map(|lids| lids.iter().map(|&at| positions[usize::from(at)]).sum::<DVec3>() / lids.len() as f64)
}
