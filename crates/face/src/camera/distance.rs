//! Estimation of the camera's distance from perspective: the nearer the camera, the larger the nose appears relative to
//! the ears.

use glam::{DMat3, DQuat, DVec2, DVec3};
use nalgebra::{SMatrix, SVector};

use crate::camera::depth::turn_rad;
use crate::procrustes::{Pair, fit};
use crate::{FaceError, canonical_positions_m};

/// Estimate of the distance from the landmarks and a prior, for a face of canonical size.
#[derive(Debug, Clone)]
pub(crate) struct Evidence {
    /// Distance in m: the exponential of the posterior mean of its logarithm.
    pub(crate) distance_m: f64,
    /// Relative standard deviation.
    pub(crate) error: f64,
    /// Log-likelihoods at [`DISTANCES_M`] from the landmarks alone, relative to the maximum.
    log_likelihoods: [f64; DISTANCES_M.len()],
}

/// Distances at which the canonical face is fitted to the landmarks, in m.
const DISTANCES_M: [f64; 15] = [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.85, 1.0, 1.3, 1.7, 2.5, 4.0];

/// Transition of the robust cost, in m: quadratic below, linear above, since real faces differ from the canonical one.
const SOFT_M: f64 = 0.001;

/// Effective number of independent measurements for a frontal face. It is below 468 because deviations of the landmarks
/// are correlated: a larger nose moves many of them.
const MEASUREMENTS: f64 = 300.0;
/// Turn angles, in radians, between which that number falls to zero. The network fills in hidden parts from an average
/// face, which biases the estimate towards near distances.
const TURNS_RAD: [f64; 2] = [0.21, 0.56];

/// Prior on the distance: median in m, and standard deviation of its logarithm.
const USUAL_M: f64 = 0.45;
const USUAL_DEVIATION: f64 = 0.6;

/// The network biases faces towards its training data: it under-represents the perspective difference from
/// [`BIAS_CENTRE_M`] by these shares, for nearer and for farther faces.
///
/// Measured with known cameras and heads of known shape.
const BIAS_SHARES: [f64; 2] = [0.32, 0.2];
const BIAS_CENTRE_M: f64 = 0.6;

/// Apparent distance in the network's landmarks for a camera at `distance_m`.
fn apparent_m(distance_m: f64) -> f64 {
    let usual_per_m = 1.0 / BIAS_CENTRE_M;
    let bias_share = BIAS_SHARES[usize::from(distance_m > BIAS_CENTRE_M)];
    1.0 / (usual_per_m + (1.0 - bias_share) * (1.0 / distance_m - usual_per_m))
}

impl Evidence {
    /// Log-likelihood of a distance relative to the most likely one, from the landmarks alone.
    pub(crate) fn log_likelihood(&self, distance_m: f64) -> f64 {
        interpolated(&self.log_likelihoods, distance_m)
    }
}

/// Estimates the distance from 468 landmarks in px, y up, whose depths give an initial pose.
///
/// # Errors
/// [`FaceError::Degenerate`] if they are collinear.
pub(crate) fn evidence(px: &[DVec3], principal_px: DVec2) -> Result<Evidence, FaceError> {
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
        costs[index] = view.fit(&canonical, &seen_px, apparent_m(DISTANCES_M[index]), start.scale);
        turns[index] = turn_rad(view.rotation);
    }
    let best = (0..costs.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b])).ok_or(FaceError::Degenerate)?;
    let frontal = 1.0 - ((turns[best] - TURNS_RAD[0]) / (TURNS_RAD[1] - TURNS_RAD[0])).clamp(0.0, 1.0);
    let worth = MEASUREMENTS * frontal * frontal;
    let log_likelihoods = costs.map(|cost| -0.5 * worth * (cost / costs[best]).ln());
    if !log_likelihoods.iter().all(|value| value.is_finite()) {
        return Err(FaceError::Degenerate);
    }
    let (distance_m, error) = posterior(&log_likelihoods);
    Ok(Evidence { distance_m, error, log_likelihoods })
}

/// Posterior mean and standard deviation of the log-distance; the mean is returned as a distance.
fn posterior(log_likelihoods: &[f64; DISTANCES_M.len()]) -> (f64, f64) {
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

/// Interpolates linearly in the log-distance.
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
