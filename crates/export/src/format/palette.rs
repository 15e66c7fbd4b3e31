//! Many colours as a few.

use glam::DVec3;

/// How many times the colours are shared out anew.
const ROUNDS: usize = 12;

/// A palette of at most `count` sRGB colours, and the place in it of each that was given.
///
/// k-means over the channels; the first colour is nearest to the middle of all, each further one farthest from those before
/// it, so that the same colours always give the same palette.
pub(super) fn palette(colours: &[[u8; 3]], count: usize) -> (Vec<[u8; 3]>, Vec<usize>) {
    let places: Vec<DVec3> = colours.iter().map(|colour| DVec3::from(colour.map(f64::from))).collect();
    let mut centres = far_apart(&places, count);
    for _ in 0..ROUNDS {
        let mut sums = vec![(DVec3::ZERO, 0.0); centres.len()];
        for place in &places {
            let (sum, many) = &mut sums[nearest(&centres, *place)];
            *sum += *place;
            *many += 1.0;
        }
        centres =
            sums.iter().zip(&centres).map(|(&(sum, many), old)| if many > 0.0 { sum / many } else { *old }).collect();
    }
    let shares = places.iter().map(|place| nearest(&centres, *place)).collect();
    (centres.iter().map(|centre| centre.to_array().map(|channel| channel.round() as u8)).collect(), shares)
}

fn far_apart(places: &[DVec3], count: usize) -> Vec<DVec3> {
    let middle = places.iter().sum::<DVec3>() / places.len().max(1) as f64;
    let mut centres = vec![middle];
    while centres.len() < count {
        let apart = |place: &DVec3| place.distance_squared(centres[nearest(&centres, *place)]);
        let Some(farthest) = places.iter().copied().max_by(|a, b| apart(a).total_cmp(&apart(b))) else { break };
        if apart(&farthest) == 0.0 {
            break;
        }
        centres.push(farthest);
    }
    centres
}

fn nearest(centres: &[DVec3], place: DVec3) -> usize {
    let by_distance =
        |a: &usize, b: &usize| place.distance_squared(centres[*a]).total_cmp(&place.distance_squared(centres[*b]));
    (0..centres.len()).min_by(by_distance).unwrap_or(0)
}
