//! How far away the camera stood, read off where the landmarks are seen: the nearer it is, the larger is the nose beside
//! the ears.

use glam::{DMat3, DQuat, DVec2, DVec3};
use nalgebra::{SMatrix, SVector};

use crate::camera::depth::turn_rad;
use crate::procrustes::{Pair, fit};
use crate::{FaceError, canonical_positions_m};

/// What the landmarks and experience tell of the distance, for a face of the canonical size.
#[derive(Debug, Clone)]
pub(crate) struct Evidence {
    /// The likeliest distance in m: the mean of its logarithm.
    pub(crate) distance_m: f64,
    /// One standard deviation, as a share of the distance.
    pub(crate) error: f64,
    /// Logarithms of the likelihood at [`DISTANCES_M`], from the landmarks alone, 0 at the likeliest.
    log_likelihoods: [f64; DISTANCES_M.len()],
}

/// The distances at which the canonical face is fitted to the landmarks, in m.
const DISTANCES_M: [f64; 15] = [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.85, 1.0, 1.3, 1.7, 2.5, 4.0];

/// Errors of a landmark are counted by their square up to about this, and linearly beyond: no face is the canonical one.
const SOFT_M: f64 = 0.001;

/// How many independent measurements the landmarks of a face that looks at the camera are worth. They are 468, but a nose
/// that is larger than usual moves many of them.
const MEASUREMENTS: f64 = 300.0;
/// Of a face turned by more than the first, in radians, they are worth less, and from the second on nothing: what the
/// network has not seen it takes from the middle of all faces, and always near.
const TURNS_RAD: [f64; 2] = [0.21, 0.56];

/// Where photos of faces are taken from, without a look at them: the middle in m, and the deviation of its logarithm.
const USUAL_M: f64 = 0.45;
const USUAL_DEVIATION: f64 = 0.6;

/// The network draws faces towards those it has learnt from: it shows these shares less of the difference that perspective
/// makes beside a face seen from the distance below, of one that is nearer and of one that is farther away. Measured with
/// cameras of known places before a head of known shape.
const DRAWN_IN: [f64; 2] = [0.32, 0.2];
const DRAWN_TO_M: f64 = 0.6;

/// The distance from which a face seems to be seen whose camera stands that far away.
fn shown_m(distance_m: f64) -> f64 {
    let usual_per_m = 1.0 / DRAWN_TO_M;
    let drawn_in = DRAWN_IN[usize::from(distance_m > DRAWN_TO_M)];
    1.0 / (usual_per_m + (1.0 - drawn_in) * (1.0 / distance_m - usual_per_m))
}

impl Evidence {
    /// The logarithm of how much less likely this distance is than the likeliest, by the landmarks alone.
    pub(crate) fn log_likelihood(&self, distance_m: f64) -> f64 {
        interpolated(&self.log_likelihoods, distance_m)
    }
}

/// Looks at where 468 landmarks are seen: px, y up, and their depth as a first guess of the pose.
///
/// # Errors
/// [`FaceError::Degenerate`] if they lie on one line.
pub(crate) fn evidence(px: &[DVec3], principal_px: DVec2) -> Result<Evidence, FaceError> {
    let canonical = centred(canonical_positions_m());
    let pairs: Vec<Pair> =
        canonical.iter().zip(px).map(|(&source, &target)| Pair { source, target, weight: 1.0 }).collect();
    let start = fit(&pairs)?;
    let seen_px: Vec<DVec2> = px.iter().map(|p| p.truncate() - principal_px).collect();
    let mean_px = seen_px.iter().sum::<DVec2>() / seen_px.len() as f64;
    let mut view = View { rotation: start.rotation, aside_m: mean_px / start.scale, log_px_per_m: start.scale.ln() };
    let mut costs = [0.0; DISTANCES_M.len()];
    let mut turns = [0.0; DISTANCES_M.len()];
    // From far to near, each from where the one before it ended.
    for index in (0..DISTANCES_M.len()).rev() {
        costs[index] = view.settle(&canonical, &seen_px, shown_m(DISTANCES_M[index]), start.scale);
        turns[index] = turn_rad(view.rotation);
    }
    let best = (0..costs.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b])).ok_or(FaceError::Degenerate)?;
    let frontal = 1.0 - ((turns[best] - TURNS_RAD[0]) / (TURNS_RAD[1] - TURNS_RAD[0])).clamp(0.0, 1.0);
    let worth = MEASUREMENTS * frontal * frontal;
    let log_likelihoods = costs.map(|cost| -0.5 * worth * (cost / costs[best]).ln());
    if !log_likelihoods.iter().all(|value| value.is_finite()) {
        return Err(FaceError::Degenerate);
    }
    let (distance_m, error) = with_experience(&log_likelihoods);
    Ok(Evidence { distance_m, error, log_likelihoods })
}

/// The mean of the logarithm over what the landmarks and experience say together, and its deviation.
fn with_experience(log_likelihoods: &[f64; DISTANCES_M.len()]) -> (f64, f64) {
    const STEPS: usize = 240;
    let [from, to] = [DISTANCES_M[0].ln(), DISTANCES_M[DISTANCES_M.len() - 1].ln()];
    let logs = || (0..=STEPS).map(move |step| from + (to - from) * step as f64 / STEPS as f64);
    let weight = |log: f64| {
        let unusual = (log - USUAL_M.ln()) / USUAL_DEVIATION;
        (interpolated(log_likelihoods, log.exp()) - 0.5 * unusual * unusual).exp()
    };
    let total: f64 = logs().map(weight).sum();
    let mean = logs().map(|log| weight(log) * log).sum::<f64>() / total;
    let variance = logs().map(|log| weight(log) * (log - mean) * (log - mean)).sum::<f64>() / total;
    (mean.exp(), variance.sqrt())
}

/// Between the distances by their logarithms.
fn interpolated(values: &[f64; DISTANCES_M.len()], distance_m: f64) -> f64 {
    let distance_m = distance_m.clamp(DISTANCES_M[0], DISTANCES_M[DISTANCES_M.len() - 1]);
    let above = DISTANCES_M.iter().position(|&at| at >= distance_m).unwrap_or(DISTANCES_M.len() - 1).max(1);
    let [low, high] = [above - 1, above].map(|index| DISTANCES_M[index].ln());
    let share = (distance_m.ln() - low) / (high - low);
    values[above - 1] * (1.0 - share) + values[above] * share
}

fn centred(positions: Vec<DVec3>) -> Vec<DVec3> {
    let mean = positions.iter().sum::<DVec3>() / positions.len() as f64;
    positions.into_iter().map(|position| position - mean).collect()
}

/// How a camera at a given distance sees the canonical face.
struct View {
    /// From the model's frame to the camera's.
    rotation: DMat3,
    /// The middle of the face beside the camera's axis.
    aside_m: DVec2,
    /// How large the middle of the face is seen.
    log_px_per_m: f64,
}

/// Pose, place and size: turn (3), aside (2), logarithm of the size.
type Parameters = SVector<f64, 6>;

impl View {
    /// Fits the view to what is seen from that distance, by Gauss and Newton with weights (soft L1); returns the mean cost in
    /// units of [`SOFT_M`] squared.
    fn settle(&mut self, canonical: &[DVec3], seen_px: &[DVec2], distance_m: f64, unit_px_per_m: f64) -> f64 {
        const MOST_STEPS: usize = 8;
        const ENOUGH: f64 = 1e-9;
        for _ in 0..MOST_STEPS {
            let lens = self.lens(distance_m, unit_px_per_m);
            let Some(step) = self.step(canonical, seen_px, lens) else { break };
            self.take(&step);
            if step.norm() < ENOUGH {
                break;
            }
        }
        let lens = self.lens(distance_m, unit_px_per_m);
        let costs = canonical.iter().zip(seen_px).map(|(&position, &seen)| {
            let error = (lens.seen(self.rotation * position, self.aside_m) - seen) * lens.units_per_px;
            2.0 * ((1.0 + error.length_squared()).sqrt() - 1.0)
        });
        costs.sum::<f64>() / canonical.len() as f64
    }

    fn lens(&self, distance_m: f64, unit_px_per_m: f64) -> Lens {
        let focal_px = self.log_px_per_m.exp() * distance_m;
        Lens { distance_m, focal_px, units_per_px: 1.0 / (unit_px_per_m * SOFT_M) }
    }

    fn step(&self, canonical: &[DVec3], seen_px: &[DVec2], lens: Lens) -> Option<Parameters> {
        let mut normal = SMatrix::<f64, 6, 6>::zeros();
        let mut gradient = Parameters::zeros();
        for (&position, &seen) in canonical.iter().zip(seen_px) {
            let turned = self.rotation * position;
            let place = lens.seen(turned, self.aside_m);
            let error = (place - seen) * lens.units_per_px;
            let weight = 1.0 / (1.0 + error.length_squared()).sqrt();
            for axis in 0..2 {
                let slope = lens.slope(axis, turned, place);
                for (i, part) in slope.iter().enumerate() {
                    gradient[i] += part * error[axis] * weight;
                    // Half of the products: the factorisation does not read the other half, which mirrors them.
                    slope[..=i].iter().enumerate().for_each(|(j, other)| normal[(i, j)] += part * other * weight);
                }
            }
        }
        normal.cholesky().map(|factor| -factor.solve(&gradient))
    }

    fn take(&mut self, step: &Parameters) {
        let turn = DVec3::new(step[0], step[1], step[2]);
        self.rotation = DMat3::from_quat(DQuat::from_scaled_axis(turn)) * self.rotation;
        self.aside_m += DVec2::new(step[3], step[4]);
        self.log_px_per_m += step[5];
    }
}

/// How a camera at a given distance draws what it sees.
#[derive(Clone, Copy)]
struct Lens {
    distance_m: f64,
    focal_px: f64,
    /// What errors are counted in: [`SOFT_M`] in the middle of the face.
    units_per_px: f64,
}

impl Lens {
    /// Where a point is seen whose place from the face's middle is `turned`, in the camera's frame.
    fn seen(&self, turned: DVec3, aside_m: DVec2) -> DVec2 {
        (turned.truncate() + aside_m) * (self.focal_px / (self.distance_m - turned.z))
    }

    /// How one coordinate of where a point is seen, in units, changes with the parameters.
    fn slope(&self, axis: usize, turned: DVec3, place: DVec2) -> [f64; 6] {
        let along = if axis == 0 { DVec3::X } else { DVec3::Y };
        let units_per_px_m = self.units_per_px / (self.distance_m - turned.z);
        let units_per_m = units_per_px_m * self.focal_px;
        // With the point's place in the camera's frame.
        let by_place = along * units_per_m + DVec3::Z * (place[axis] * units_per_px_m);
        let by_turn = turned.cross(by_place);
        let aside = [0, 1].map(|other| if other == axis { units_per_m } else { 0.0 });
        [by_turn.x, by_turn.y, by_turn.z, aside[0], aside[1], place[axis] * self.units_per_px]
    }
}
