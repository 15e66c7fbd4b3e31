use glam::Vec3;

use crate::filling::filled;
use crate::map::{divided, mean_around};

/// A blur as wide as light changes: [`mean_around`]'s times.
const LIGHT: u32 = 4;
/// By how much a colour is made brighter or darker at most.
const MOST: f32 = 2.5;
/// Of that, what differs from place to place is this at most.
const MOST_LOCAL: f32 = 1.5;
/// What differs by more than this after the gain, or in one channel by so much more than in another, is not the same thing.
const BRIGHTER: f32 = 1.8;
const REDDER: f32 = 1.35;
/// With so much of the blur's weight in the overlap, a cell's own ratio is taken for certain.
const CERTAIN: f32 = 0.1;

/// By how much colours must be multiplied, channel by channel, to be as bright as others of the same places: one gain, then
/// what differs slowly from place to place. Where only one is known, the ratio goes on from where both are.
pub(crate) fn ratios(colours: &[Vec3], wanted: &[Vec3], overlap: &[f32]) -> Vec<Vec3> {
    let sum = |of: &[Vec3]| of.iter().zip(overlap).fold(Vec3::ZERO, |sum, (colour, weight)| sum + *colour * *weight);
    let gain = ratio(sum(wanted), sum(colours));
    let alike = |(colour, wanted): (&Vec3, &Vec3)| is_light(ratio(*wanted, *colour * gain));
    let alike = colours.iter().zip(wanted).map(alike).zip(overlap);
    let overlap: Vec<f32> = alike.map(|(is_light, overlap)| if is_light { *overlap } else { 0.0 }).collect();
    let (means, weights) = mean_around(colours, &overlap, LIGHT);
    let wanted_means = mean_around(wanted, &overlap, LIGHT).0;
    // As what is more or less than 1, so that it is 1 where nothing is known at all.
    let local = |(wanted, mean): (&Vec3, &Vec3)| local_ratio(*wanted, *mean * gain) - Vec3::ONE;
    let local: Vec<Vec3> = wanted_means.iter().zip(&means).map(local).collect();
    let known: Vec<f32> = weights.into_iter().map(|weight| (weight / CERTAIN).min(1.0)).collect();
    filled(&local, &known).into_iter().map(|more| (more + Vec3::ONE) * gain).collect()
}

/// Whether a ratio is one that light makes, and not that of two things.
fn is_light(ratio: Vec3) -> bool {
    let (most, least) = (ratio.max_element(), ratio.min_element());
    most < BRIGHTER && least * BRIGHTER > 1.0 && most < REDDER * least
}

fn local_ratio(wanted: Vec3, found: Vec3) -> Vec3 {
    ratio(wanted, found).clamp(Vec3::splat(1.0 / MOST_LOCAL), Vec3::splat(MOST_LOCAL))
}

/// 1 where there is nothing to compare.
fn ratio(wanted: Vec3, found: Vec3) -> Vec3 {
    let channel = |wanted: f32, found: f32| {
        if found > 0.0 && wanted > 0.0 { divided(wanted, found).clamp(1.0 / MOST, MOST) } else { 1.0 }
    };
    Vec3::new(channel(wanted.x, found.x), channel(wanted.y, found.y), channel(wanted.z, found.z))
}
