//! Estimation of the camera's distance from perspective: the nearer the camera, the larger the nose appears relative to
//! the ears.

use std::f64::consts::FRAC_PI_6;

use glam::{DMat3, DQuat, DVec2, DVec3};
use nalgebra::{SMatrix, SVector};

use crate::procrustes::{Pair, fit};
use crate::{FaceError, canonical_positions_m};

/// Distance with its uncertainty.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Distance {
    pub(crate) distance_m: f64,
    /// Natural logarithms of the ends of the 90 % interval, relative to `distance_m`.
    pub(crate) log_interval: [f64; 2],
}

/// Distances at which the canonical face is fitted to the landmarks, in m.
const DISTANCES_M: [f64; 16] = [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.85, 1.0, 1.3, 1.7, 2.5, 4.0, 8.0];

/// Transition of the robust cost, in m: quadratic below, linear above, since real faces differ from the canonical one.
const SOFT_M: f64 = 0.001;

/// The inverse distance at which the canonical face fits best, given the true inverse distance y, is
/// `OFFSET_PER_M + TURNED_PER_M (turn / 30°)² + SHARE y`, with a standard deviation of [`DEVIATION_PER_M`]: the network
/// draws faces towards an average view, and a face with a longer nose looks nearer.
///
/// Measured on sixteen heads of known shape, between which the offset ranges from 0.4 to 2.
const SHARE: f64 = 0.65;
const OFFSET_PER_M: f64 = 1.0;
const TURNED_PER_M: f64 = 0.35;
const DEVIATION_PER_M: f64 = 0.5;

/// Largest inverse distance at which a face is believed to fit best.
const MAX_PER_M: f64 = 6.0;

/// Prior on the distance, a mixture of two log-normal distributions: weight, median in m, standard deviation of the
/// logarithm. Most selfies are taken from 25 to 60 cm, most portraits from 1 to 3 m (Ward and others 2018).
const PRIOR: [[f64; 3]; 2] = [[0.65, 0.42, 0.3], [0.35, 1.7, 0.4]];

/// Half of a normal distribution's 90 % interval, in standard deviations.
const DEVIATIONS: f64 = 1.645;

/// Estimates the distance of a face of canonical size from 468 landmarks in px, y up, whose depths give an initial
/// pose: the exponential of the posterior mean of its logarithm.
///
/// # Errors
/// [`FaceError::Degenerate`] if they are collinear.
pub(crate) fn estimated(px: &[DVec3], principal_px: DVec2) -> Result<Distance, FaceError> {
    let canonical = centred(canonical_positions_m());
    let pairs: Vec<Pair> =
        canonical.iter().zip(px).map(|(&source, &target)| Pair { source, target, weight: 1.0 }).collect();
    let start = fit(&pairs)?;
    let seen_px: Vec<DVec2> = px.iter().map(|p| p.truncate() - principal_px).collect();
    let mean_px = seen_px.iter().sum::<DVec2>() / seen_px.len() as f64;
    let mut view =
        FacePose { rotation: start.rotation, offset_m: mean_px / start.scale, log_px_per_m: start.scale.ln() };
    let mut costs = [0.0; DISTANCES_M.len()];
    let mut turns = [0.0; DISTANCES_M.len()];
    // From far to near, each fit starts at the previous result.
    for index in (0..DISTANCES_M.len()).rev() {
        costs[index] = view.fit(&canonical, &seen_px, DISTANCES_M[index], start.scale);
        turns[index] = turn_rad(view.rotation);
    }
    let best = (0..costs.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b])).ok_or(FaceError::Degenerate)?;
    if !costs.iter().all(|cost| cost.is_finite()) {
        return Err(FaceError::Degenerate);
    }
    Ok(posterior(least(&costs, best), turns[best]))
}

/// Inverse distance of the least cost, by a parabola through the costs around `best`.
fn least(costs: &[f64; DISTANCES_M.len()], best: usize) -> f64 {
    let middle = best.clamp(1, costs.len() - 2);
    let [x, y] = [0, 1].map(|axis| {
        [middle - 1, middle, middle + 1].map(|index| if axis == 0 { 1.0 / DISTANCES_M[index] } else { costs[index] })
    });
    let slopes = [0, 1].map(|at| (y[at + 1] - y[at]) / (x[at + 1] - x[at]));
    let bend = (slopes[1] - slopes[0]) / (x[2] - x[0]);
    if bend <= 0.0 {
        return 1.0 / DISTANCES_M[best];
    }
    ((x[0] + x[1] - slopes[0] / bend) / 2.0).clamp(0.0, MAX_PER_M)
}

/// Posterior of the distance, for the inverse distance at which the canonical face fits best.
fn posterior(apparent_per_m: f64, turn_rad: f64) -> Distance {
    const STEPS: usize = 240;
    let [from, to] = [DISTANCES_M[0].ln(), DISTANCES_M[DISTANCES_M.len() - 1].ln()];
    let turn = turn_rad / FRAC_PI_6;
    let offset_per_m = OFFSET_PER_M + TURNED_PER_M * turn * turn;
    let normal = |deviations: f64| (-0.5 * deviations * deviations).exp();
    let weights: Vec<(f64, f64)> = (0..=STEPS)
        .map(|step| {
            let log = from + (to - from) * step as f64 / STEPS as f64;
            let expected_per_m = offset_per_m + SHARE * (-log).exp();
            let likelihood = normal((apparent_per_m - expected_per_m) / DEVIATION_PER_M);
            let prior =
                PRIOR.map(|[weight, median_m, spread]| weight / spread * normal((log - median_m.ln()) / spread));
            (log, likelihood * (prior[0] + prior[1]))
        })
        .collect();
    let total: f64 = weights.iter().map(|(_, weight)| weight).sum();
    let mean = weights.iter().map(|(log, weight)| weight * log).sum::<f64>() / total;
    let quantile = |share: f64| {
        let mut below = 0.0;
        let reached = weights.iter().find(|(_, weight)| {
            below += weight / total;
            below >= share
        });
        reached.map_or(to, |(log, _)| *log) - mean
    };
    Distance { distance_m: mean.exp(), log_interval: [quantile(0.05), quantile(0.95)] }
}

/// 90 % interval around a distance in m, with a further relative standard deviation.
pub(crate) fn interval_m(distance_m: f64, log_interval: [f64; 2], deviation: f64) -> [f64; 2] {
    log_interval.map(|end| distance_m * end.hypot(DEVIATIONS * deviation).copysign(end).exp())
}

/// Natural logarithms of the ends of a 90 % interval, for a relative standard deviation.
pub(crate) fn log_interval(deviation: f64) -> [f64; 2] {
    [-DEVIATIONS * deviation, DEVIATIONS * deviation]
}

fn centred(positions: Vec<DVec3>) -> Vec<DVec3> {
    let mean = positions.iter().sum::<DVec3>() / positions.len() as f64;
    positions.into_iter().map(|position| position - mean).collect()
}

/// Angle between the face's axis and the direction to the camera, in radians.
pub(crate) fn turn_rad(camera_from_model: DMat3) -> f64 {
    (camera_from_model * DVec3::Z).normalize().z.clamp(-1.0, 1.0).acos()
}

/// Similarity pose of the canonical face, as seen by a camera at a given distance.
struct FacePose {
    /// Rotation from the model's frame to the camera's.
    rotation: DMat3,
    /// Offset of the face's centre from the camera's axis.
    offset_m: DVec2,
    /// Logarithm of the scale at the face's centre.
    log_px_per_m: f64,
}

/// Step: rotation vector (3), offset (2), logarithm of the scale.
type Parameters = SVector<f64, 6>;

impl FacePose {
    /// Fits the pose at a given distance by Gauss–Newton with soft-L1 weights. Returns the mean cost in units of
    /// [`SOFT_M`] squared.
    fn fit(&mut self, canonical: &[DVec3], seen_px: &[DVec2], distance_m: f64, unit_px_per_m: f64) -> f64 {
        const MAX_STEPS: usize = 8;
        const TOLERANCE: f64 = 1e-9;
        for _ in 0..MAX_STEPS {
            let lens = self.lens(distance_m, unit_px_per_m);
            let Some(step) = self.step(canonical, seen_px, lens) else { break };
            self.take(&step);
            if step.norm() < TOLERANCE {
                break;
            }
        }
        let lens = self.lens(distance_m, unit_px_per_m);
        let costs = canonical.iter().zip(seen_px).map(|(&position, &seen)| {
            let error = (lens.seen(self.rotation * position, self.offset_m) - seen) * lens.units_per_px;
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
            let rotated = self.rotation * position;
            let projected = lens.seen(rotated, self.offset_m);
            let error = (projected - seen) * lens.units_per_px;
            let weight = 1.0 / (1.0 + error.length_squared()).sqrt();
            for axis in 0..2 {
                let slope = lens.slope(axis, rotated, projected);
                for (i, part) in slope.iter().enumerate() {
                    gradient[i] += part * error[axis] * weight;
                    // Lower triangle only: the factorisation does not read the upper one.
                    slope[..=i].iter().enumerate().for_each(|(j, other)| normal[(i, j)] += part * other * weight);
                }
            }
        }
        normal.cholesky().map(|factor| -factor.solve(&gradient))
    }

    fn take(&mut self, step: &Parameters) {
        let turn = DVec3::new(step[0], step[1], step[2]);
        self.rotation = DMat3::from_quat(DQuat::from_scaled_axis(turn)) * self.rotation;
        self.offset_m += DVec2::new(step[3], step[4]);
        self.log_px_per_m += step[5];
    }
}

/// Projection of a camera at a given distance.
#[derive(Clone, Copy)]
struct Lens {
    distance_m: f64,
    focal_px: f64,
    /// Units of the residuals: [`SOFT_M`] at the face's centre.
    units_per_px: f64,
}

impl Lens {
    /// Projects a point given relative to the face's centre, in the camera's frame.
    fn seen(&self, rotated: DVec3, offset_m: DVec2) -> DVec2 {
        (rotated.truncate() + offset_m) * (self.focal_px / (self.distance_m - rotated.z))
    }

    /// Derivative of one projected coordinate, in residual units, by the parameters.
    fn slope(&self, axis: usize, rotated: DVec3, projected: DVec2) -> [f64; 6] {
        let along = if axis == 0 { DVec3::X } else { DVec3::Y };
        let units_per_px_m = self.units_per_px / (self.distance_m - rotated.z);
        let units_per_m = units_per_px_m * self.focal_px;
        // Derivative by the position in the camera's frame.
        let by_position = along * units_per_m + DVec3::Z * (projected[axis] * units_per_px_m);
        let by_rotation = rotated.cross(by_position);
        let by_offset = [0, 1].map(|other| if other == axis { units_per_m } else { 0.0 });
        [by_rotation.x, by_rotation.y, by_rotation.z, by_offset[0], by_offset[1], projected[axis] * self.units_per_px]
    }
}
