use glam::Vec3;

use crate::filling::filled;
use crate::map::{divided, mean_around};

/// Levels of [`mean_around`] that match the scale of lighting.
const LIGHT: u32 = 4;
/// Maximum factor of a colour.
const MAX_RATIO: f32 = 2.5;
/// Maximum local factor, on top of the global gain.
const MAX_LOCAL_RATIO: f32 = 1.5;
/// Limits on brightness and on the ratio between channels, after the gain; beyond them, two colours show different
/// things.
const BRIGHTER: f32 = 1.8;
const REDDER: f32 = 1.35;
/// Weight of the overlap at which a cell's own ratio is fully trusted.
const FULL_WEIGHT: f32 = 0.1;

/// Ratios per channel that match colours to a reference: a global gain times a slowly varying local ratio. Outside the
/// overlap, the local ratio is extrapolated.
pub(crate) fn ratios(colours: &[Vec3], reference: &[Vec3], overlap: &[f32]) -> Vec<Vec3> {
    let sum = |of: &[Vec3]| of.iter().zip(overlap).fold(Vec3::ZERO, |sum, (colour, weight)| sum + *colour * *weight);
    let gain = ratio(sum(reference), sum(colours));
    let alike = |(colour, reference): (&Vec3, &Vec3)| is_light(ratio(*reference, *colour * gain));
    let alike = colours.iter().zip(reference).map(alike).zip(overlap);
    let overlap: Vec<f32> = alike.map(|(is_light, overlap)| if is_light { *overlap } else { 0.0 }).collect();
    let (means, weights) = mean_around(colours, &overlap, LIGHT);
    let reference_means = mean_around(reference, &overlap, LIGHT).0;
    // Relative to 1, so that filling yields 1 without an overlap.
    let local = |(reference, mean): (&Vec3, &Vec3)| local_ratio(*reference, *mean * gain) - Vec3::ONE;
    let local: Vec<Vec3> = reference_means.iter().zip(&means).map(local).collect();
    let known: Vec<f32> = weights.into_iter().map(|weight| (weight / FULL_WEIGHT).min(1.0)).collect();
    filled(&local, &known).into_iter().map(|more| (more + Vec3::ONE) * gain).collect()
}

/// Whether a difference in lighting can explain the ratio.
fn is_light(ratio: Vec3) -> bool {
    let (most, least) = (ratio.max_element(), ratio.min_element());
    most < BRIGHTER && least * BRIGHTER > 1.0 && most < REDDER * least
}

fn local_ratio(reference: Vec3, found: Vec3) -> Vec3 {
    ratio(reference, found).clamp(Vec3::splat(1.0 / MAX_LOCAL_RATIO), Vec3::splat(MAX_LOCAL_RATIO))
}

/// Ratio per channel; 1 where a value is missing.
fn ratio(reference: Vec3, found: Vec3) -> Vec3 {
    let channel = |reference: f32, found: f32| {
        if found > 0.0 && reference > 0.0 { divided(reference, found).clamp(1.0 / MAX_RATIO, MAX_RATIO) } else { 1.0 }
    };
    Vec3::new(channel(reference.x, found.x), channel(reference.y, found.y), channel(reference.z, found.z))
}
