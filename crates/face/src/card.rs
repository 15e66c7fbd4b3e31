//! Size of a face, measured by a bank card that is held against it.

use glam::{DMat3, DVec2, DVec3};
use nalgebra::{SMatrix, SVector};

use crate::FaceError;

/// Corners of a bank card in a photo, in any order: x/W and y/H from the top left.
pub type CardCorners = [[f64; 2]; 4];

/// Width and height of a card in m (ISO/IEC 7810, ID-1).
const CARD_M: DVec2 = DVec2::new(0.085_6, 0.053_98);

/// Landmarks against which a card is held: the forehead and the chin.
const TOUCHED: [usize; 4] = [10, 151, 199, 152];

/// Focal length that stands for parallel projection.
const LONGEST_PX: f64 = 1e7;

/// Largest relative difference between the sides of a card as measured and as they are. Taps miss by a few per cent; a
/// square differs by 0.6.
const MAX_DISTORTION: f64 = 0.15;

/// Size of 1 px at the face's centre, in m. `points` are the unprojected landmarks, `corners_px` the card's corners, both
/// relative to the principal point, y up.
///
/// The homography from card to picture gives the card's pose, and so its distance from the camera. The card touches the
/// nearest landmark of forehead or chin, whose depth relative to the face's centre is known.
///
/// # Errors
/// [`FaceError::NotACard`] if no card of that shape looks like this.
pub(crate) fn m_per_px(points: &[DVec3], corners_px: [DVec2; 4], focal_px: f64) -> Result<f64, FaceError> {
    let focal_px = focal_px.min(LONGEST_PX);
    let ordered = around(corners_px);
    let poses = [0, 1].map(|turn| pose([0, 1, 2, 3].map(|at| ordered[(at + turn) % 4]), focal_px));
    let best = poses.into_iter().flatten().min_by(|a, b| a.distortion.total_cmp(&b.distortion));
    let pose = best.filter(|pose| pose.distortion <= MAX_DISTORTION).ok_or(FaceError::NotACard)?;
    let middle_px = corners_px.iter().sum::<DVec2>() / 4.0;
    let apart_px = |point: &DVec3| (point.truncate() / (1.0 - point.z / focal_px)).distance(middle_px);
    let touched = TOUCHED.map(|landmark| points[landmark]).into_iter();
    let touched = touched.min_by(|a, b| apart_px(a).total_cmp(&apart_px(b))).ok_or(FaceError::NotACard)?;
    Ok(pose.distance_m / (focal_px - touched.z))
}

/// Corners in the order of their angles around the middle.
fn around(mut corners: [DVec2; 4]) -> [DVec2; 4] {
    let middle = corners.iter().sum::<DVec2>() / 4.0;
    let angle = |corner: &DVec2| (*corner - middle).to_angle();
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    corners
}

/// Pose of a card.
struct CardPose {
    /// Distance of its middle along the camera's axis, in m.
    distance_m: f64,
    /// Relative difference between its sides as measured and as they are, or the cosine of the angle between them.
    distortion: f64,
}

/// Pose of a card whose corners are seen at `corners_px`, the first two at its lower side.
fn pose(corners_px: [DVec2; 4], focal_px: f64) -> Option<CardPose> {
    let half = CARD_M / 2.0;
    let corners_m = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec2::new(x, y) * half);
    let picture_from_card = homography(corners_m, corners_px.map(|corner| corner / focal_px))?;
    let [right, up, middle] = [0, 1, 2].map(|column| picture_from_card.col(column));
    let lengths = [right.length(), up.length()];
    let per_m = (lengths[0] * lengths[1]).sqrt();
    let distortion = (lengths[0] / lengths[1]).ln().abs().max(right.dot(up).abs() / (lengths[0] * lengths[1]));
    let distance_m = middle.z / per_m;
    (distance_m.is_finite() && distance_m > 0.0).then_some(CardPose { distance_m, distortion })
}

/// Homography that maps four points of a plane to four points of another one, with a last element of 1.
fn homography(from: [DVec2; 4], to: [DVec2; 4]) -> Option<DMat3> {
    let mut system = SMatrix::<f64, 8, 8>::zeros();
    let mut values = SVector::<f64, 8>::zeros();
    for (index, (from, to)) in from.iter().zip(to).enumerate() {
        for (axis, value) in to.to_array().into_iter().enumerate() {
            let row = 2 * index + axis;
            system.fixed_view_mut::<1, 3>(row, 3 * axis).copy_from_slice(&[from.x, from.y, 1.0]);
            system.fixed_view_mut::<1, 2>(row, 6).copy_from_slice(&[-value * from.x, -value * from.y]);
            values[row] = value;
        }
    }
    let h = system.lu().solve(&values)?;
    Some(DMat3::from_cols(DVec3::new(h[0], h[3], h[6]), DVec3::new(h[1], h[4], h[7]), DVec3::new(h[2], h[5], 1.0)))
}
