//! Size of a face, measured by its irises.

use glam::DVec3;

use crate::LANDMARK_COUNT;
use crate::irises::{MIDDLE_OF_LIDS, POINT_COUNT, POINTS_OF_AN_IRIS};

/// Source and accuracy of a face's size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Irises if they were measured, otherwise the canonical face.
    pub source: ScaleSource,
    /// Relative standard deviation of lengths.
    pub error: f64,
}

rosto_mesh::named! {
    /// Reference for a face's size.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ScaleSource {
        /// The irises, with an average diameter of 11.7 mm.
        Irises = "irises",
        /// The canonical face, an average adult.
        Canonical = "canonical",
    }
}

/// Diameter of an iris and its deviation in the population, in metres (Hashemi et al. 2009; MediaPipe Iris).
const IRIS_M: f64 = 0.011_7;
const IRIS_DEVIATION_M: f64 = 0.000_5;

/// Relative deviation of adults' head size.
const CANONICAL_ERROR: f64 = 0.06;

/// Smallest visible height of an iris between the lids, relative to its diameter.
const LEAST_OPENING: f64 = 0.45;
/// Largest relative difference between both irises, and between height and width of one.
const MOST_DIFFERENCE: f64 = 0.25;
/// Plausible sizes relative to the canonical face.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.7..=1.35;

/// Size of a face relative to the canonical face, with its accuracy. `unprojected` has the landmarks in px, followed by
/// the irises, if any; `m_per_px` scales the face to canonical size.
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

/// Diameter of an iris if enough of it is visible: the longer axis, since rotation and gaze shorten the other.
fn diameter(iris: &[DVec3], [upper, lower]: [DVec3; 2]) -> Option<f64> {
    let [wide, high] = [[1, 3], [2, 4]].map(|[a, b]: [usize; 2]| iris[a].distance(iris[b]));
    let diameter = wide.max(high);
    let is_round = wide.min(high) >= (1.0 - MOST_DIFFERENCE) * diameter;
    (is_round && upper.distance(lower) >= LEAST_OPENING * diameter).then_some(diameter)
}
