//! How large a face really is, by its irises.

use glam::DVec3;

use crate::LANDMARK_COUNT;
use crate::irises::{MIDDLE_OF_LIDS, POINT_COUNT, POINTS_OF_AN_IRIS};

/// How large a face is, and how that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Whether it was measured on the irises; else the face is as large as the canonical one.
    pub source: ScaleSource,
    /// One standard deviation of every length, as a share of it.
    pub error: f64,
}

rosto_mesh::named! {
    /// What a face's size was taken from.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ScaleSource {
        /// The irises, 11.7 mm across in nearly everybody.
        Irises = "irises",
        /// The canonical face: an average adult's.
        Canonical = "canonical",
    }
}

/// Across an iris, and its deviation between people, in metres (Hashemi et al. 2009; MediaPipe Iris).
const IRIS_M: f64 = 0.011_7;
const IRIS_DEVIATION_M: f64 = 0.000_5;

/// How much adults differ in size.
const CANONICAL_ERROR: f64 = 0.06;

/// An iris that the lids leave less of, as a share of its diameter, cannot be seen well enough.
const LEAST_OPENING: f64 = 0.45;
/// Both irises, and height and width of each, differ by no more than this share.
const MOST_DIFFERENCE: f64 = 0.25;
/// What the irises say of the size of a face, beside the canonical one's.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.7..=1.35;

/// How many times the canonical face's size this face has, and how well that is known. `unprojected` are its points in px,
/// those of the irises behind the landmarks, if there are any; `m_per_px` makes the face as large as the canonical one.
pub(crate) fn scale(unprojected: &[DVec3], m_per_px: f64) -> (f64, Scale) {
    let canonical = (1.0, Scale { source: ScaleSource::Canonical, error: CANONICAL_ERROR });
    let Some(irises) = unprojected.get(LANDMARK_COUNT..POINT_COUNT) else { return canonical };
    let (right, left) = irises.split_at(POINTS_OF_AN_IRIS);
    let [right_lids, left_lids] = MIDDLE_OF_LIDS.map(|lids| lids.map(|lid| unprojected[lid]));
    let (Some(right), Some(left)) = (diameter(right, right_lids), diameter(left, left_lids)) else { return canonical };
    let (mean, difference) = ((right + left) / 2.0, (right - left).abs() / right.max(left));
    let factor = IRIS_M / (mean * m_per_px);
    if difference > MOST_DIFFERENCE || !PLAUSIBLE.contains(&factor) {
        return canonical;
    }
    (factor, Scale { source: ScaleSource::Irises, error: (IRIS_DEVIATION_M / IRIS_M).hypot(difference / 2.0) })
}

/// Across one iris, if enough of it is seen: the longer of its two axes, since a turn or a look aside shortens the other.
fn diameter(iris: &[DVec3], [upper, lower]: [DVec3; 2]) -> Option<f64> {
    let [wide, high] = [[1, 3], [2, 4]].map(|[a, b]: [usize; 2]| iris[a].distance(iris[b]));
    let diameter = wide.max(high);
    let is_round = wide.min(high) >= (1.0 - MOST_DIFFERENCE) * diameter;
    (is_round && upper.distance(lower) >= LEAST_OPENING * diameter).then_some(diameter)
}
