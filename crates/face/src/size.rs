//! Size of a face, measured by its irises.

use std::f64::consts::FRAC_PI_6;

use glam::DVec3;

use crate::LANDMARK_COUNT;
use crate::irises::{MIDDLE_OF_LIDS, POINT_COUNT, POINTS_OF_AN_IRIS};

/// Source and accuracy of a face's size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// A card, if there is one; otherwise the irises, if they were measured; otherwise the canonical face.
    pub source: ScaleSource,
    /// Relative standard deviation of lengths.
    pub error: f64,
}

rosto_mesh::named! {
    /// Reference for a face's size.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ScaleSource {
        /// The irises, with an average diameter of 11.8 mm.
        Irises = "irises",
        /// A bank card, 85.6 × 54 mm.
        Card = "card",
        /// The canonical face, of an average size.
        Canonical = "canonical",
    }
}

/// Visible diameter of an iris and its deviation in the population, in metres (Rüfer and others 2005; Hashemi and others
/// 2009).
const IRIS_M: f64 = 0.011_8;
const IRIS_DEVIATION_M: f64 = 0.000_5;
/// Relative deviation of the measured diameter, from the front; twice that at 30°.
const MEASURED_ERROR: f64 = 0.045;
/// Diameter of an iris relative to its height between the lids, as the network finds it.
const PER_HEIGHT: f64 = 1.09;

/// Relative deviation of head sizes, of adults and children.
const CANONICAL_ERROR: f64 = 0.08;

/// Relative deviation of a size that a card gives, for corners marked to about 1 % of its width.
const CARD_ERROR: f64 = 0.01;

/// Smallest visible height of an iris between the lids, relative to its diameter.
const LEAST_OPENING: f64 = 0.45;
/// Largest relative difference between both irises, and between height and width of one.
const MOST_DIFFERENCE: f64 = 0.25;
/// Plausible sizes relative to the canonical face.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.7..=1.35;

/// Size of a face relative to the canonical face, with its accuracy: the mean of what the irises say and of the canonical
/// size, weighted by their errors. `unprojected` has the landmarks in px, followed by the irises, if any; `m_per_px`
/// scales the face to canonical size. Irises of a head turned by `turn_rad` are measured less accurately.
pub(crate) fn scale(unprojected: &[DVec3], m_per_px: f64, turn_rad: f64) -> (f64, Scale) {
    let canonical = (1.0, Scale { source: ScaleSource::Canonical, error: CANONICAL_ERROR });
    let Some(diameter_px) = diameter(unprojected) else { return canonical };
    let by_irises = IRIS_M / (diameter_px * m_per_px);
    if !PLAUSIBLE.contains(&by_irises) {
        return canonical;
    }
    let turn = turn_rad / FRAC_PI_6;
    let irises_error = (IRIS_DEVIATION_M / IRIS_M).hypot(MEASURED_ERROR * (1.0 + turn * turn));
    let [by_irises_weight, canonical_weight] = [irises_error, CANONICAL_ERROR].map(|error| 1.0 / (error * error));
    let weight = by_irises_weight + canonical_weight;
    let scale = Scale { source: ScaleSource::Irises, error: 1.0 / weight.sqrt() };
    (by_irises.powf(by_irises_weight / weight), scale)
}

/// Size of a face relative to the canonical face, by a card that gives the size of a pixel at the face's centre.
pub(crate) fn scale_by_card(m_per_px: f64, canonical_m_per_px: f64) -> (f64, Scale) {
    (m_per_px / canonical_m_per_px, Scale { source: ScaleSource::Card, error: CARD_ERROR })
}

/// Diameter of the irises, if enough of both is visible. Turning the head narrows them and the lids cover their tops, so
/// the larger of width and corrected height counts.
fn diameter(unprojected: &[DVec3]) -> Option<f64> {
    let (right, left) = unprojected.get(LANDMARK_COUNT..POINT_COUNT)?.split_at(POINTS_OF_AN_IRIS);
    let [right_lids, left_lids] = MIDDLE_OF_LIDS.map(|lids| lids.map(|lid| unprojected[lid]));
    let (right, left) = (axes(right, right_lids)?, axes(left, left_lids)?);
    let [right_longest, left_longest] = [right, left].map(|[wide, high]| wide.max(high));
    let is_alike = (right_longest - left_longest).abs() <= MOST_DIFFERENCE * right_longest.max(left_longest);
    let [wide, high] = [0, 1].map(|axis| (right[axis] + left[axis]) / 2.0);
    is_alike.then_some(wide.max(PER_HEIGHT * high))
}

/// Width and height of an iris, if enough of it is visible.
fn axes(iris: &[DVec3], [upper, lower]: [DVec3; 2]) -> Option<[f64; 2]> {
    let [wide, high] = [[1, 3], [2, 4]].map(|[a, b]: [usize; 2]| iris[a].distance(iris[b]));
    let longest = wide.max(high);
    let is_round = wide.min(high) >= (1.0 - MOST_DIFFERENCE) * longest;
    (is_round && upper.distance(lower) >= LEAST_OPENING * longest).then_some([wide, high])
}
