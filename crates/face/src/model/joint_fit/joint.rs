//! Joint optimisation of the lead photo's depths and the other photos' cameras.

use nalgebra::{DMatrix, DVector};
use nalgebra_sparse::CsrMatrix;
use rosto_laplacian::{Factor, Operator};

use super::camera_pose::PARAMETERS;
use super::other_view::{OtherView, Slopes};
use super::rays::Rays;
use crate::{FaceError, LANDMARK_COUNT, Triangulation};

/// Prior standard deviations of the lead photo's depths, and of their δ-coordinates.
const DEPTH_M: f64 = 0.02;
const DELTA_M: f64 = 0.000_15;

/// Joint least-squares problem. Minimises
///
/// `Σₖ Σᵢ wₖᵢ ρ(|πₖ(xᵢ + (zᵢ + dᵢ) rᵢ) − sₖᵢ| / σₖ) + |z / DEPTH_M|² + |L z / DELTA_M|²`
///
/// over the displacements z of the landmarks towards the lead camera, in m, and the other cameras π. x is the shape
/// from the lead photo alone, r its rays, d the network's depth bias, s the observations, ρ(e) = 2(√(1 + e²) − 1), and
/// L the random-walk graph Laplacian.
///
/// Solved by Gauss–Newton with iteratively updated weights. Each step eliminates the depths first, because their block
/// of the normal matrix is as sparse as the mesh.
pub(super) struct Joint<'a> {
    rays: &'a Rays,
    /// Prior on the depths: the part of the normal matrix that does not depend on the photos.
    prior: CsrMatrix<f64>,
}

impl<'a> Joint<'a> {
    pub(super) fn new(rays: &'a Rays) -> Result<Self, FaceError> {
        let operator = Operator::Uniform.matrix(&Triangulation::Canonical.topology(), &rays.positions_m);
        let operator = operator.map_err(|_| FaceError::Degenerate)?;
        let bending = operator.transpose() * &operator * (1.0 / (DELTA_M * DELTA_M));
        let prior = CsrMatrix::identity(LANDMARK_COUNT) * (1.0 / (DEPTH_M * DEPTH_M)) + bending;
        Ok(Self { rays, prior })
    }

    /// Optimises the depths, which are returned as displacements towards the camera, and the other cameras.
    pub(super) fn optimise(&self, others: &mut [OtherView]) -> Result<Vec<f64>, FaceError> {
        const MAX_STEPS: usize = 100;
        const TOLERANCE_M: f64 = 1e-12;
        let mut nearer_m = vec![0.0; LANDMARK_COUNT];
        for _ in 0..MAX_STEPS {
            let step_m = self.step(others, &nearer_m)?;
            nearer_m.iter_mut().zip(&step_m).for_each(|(nearer_m, step_m)| *nearer_m += step_m);
            let largest_m = step_m.iter().fold(0.0, |most: f64, step_m| most.max(step_m.abs()));
            if !largest_m.is_finite() {
                return Err(FaceError::Degenerate);
            }
            if largest_m < TOLERANCE_M {
                break;
            }
        }
        Ok(nearer_m)
    }

    /// One Gauss–Newton step: updates the cameras, and returns the step of the depths.
    fn step(&self, others: &mut [OtherView], nearer_m: &[f64]) -> Result<Vec<f64>, FaceError> {
        let biased_m = self.rays.biased_nearer_m(nearer_m);
        others.iter_mut().for_each(|other| other.update_error_scale(&biased_m));
        let slopes: Vec<Slopes> = others.iter().map(|other| other.slopes(&biased_m, &self.rays.directions)).collect();
        let depths = self.factor(&slopes)?;
        let mut depth_step = self.descent(&slopes, nearer_m);
        depths.solve(&mut depth_step);
        let mixed = mixed_derivatives(&slopes);
        let solved: Vec<Vec<f64>> = mixed.iter().map(|column| solved(&depths, column)).collect();
        let poses = poses(&slopes, &mixed, &solved, &depth_step).ok_or(FaceError::Degenerate)?;
        for (other, step) in others.iter_mut().zip(poses.as_slice().chunks_exact(PARAMETERS)) {
            other.pose.apply(&super::camera_pose::Parameters::from_column_slice(step));
        }
        for (column, step) in solved.iter().zip(poses.iter()) {
            depth_step.iter_mut().zip(column).for_each(|(depth_step, value)| *depth_step -= value * step);
        }
        Ok(depth_step)
    }

    fn factor(&self, slopes: &[Slopes]) -> Result<Factor, FaceError> {
        let mut normal = self.prior.clone();
        for (row, column, value) in normal.triplet_iter_mut() {
            if row == column {
                *value += slopes.iter().map(|slopes| slopes.depths[row].0).sum::<f64>();
            }
        }
        Factor::new(&normal).map_err(|_| FaceError::Degenerate)
    }

    /// Negative gradient by the depths.
    fn descent(&self, slopes: &[Slopes], nearer_m: &[f64]) -> Vec<f64> {
        let prior = &self.prior * &DVector::from_column_slice(nearer_m);
        let observed = |landmark: usize| slopes.iter().map(|slopes| slopes.depths[landmark].1).sum::<f64>();
        prior.iter().enumerate().map(|(landmark, prior)| -prior - observed(landmark)).collect()
    }
}

/// Mixed second derivatives by depth and by each camera parameter.
fn mixed_derivatives(slopes: &[Slopes]) -> Vec<Vec<f64>> {
    let columns = slopes.iter().flat_map(|slopes| (0..PARAMETERS).map(move |parameter| (slopes, parameter)));
    columns.map(|(slopes, parameter)| slopes.depths.iter().map(|depth| depth.2[parameter]).collect()).collect()
}

fn solved(depths: &Factor, column: &[f64]) -> Vec<f64> {
    let mut solved = column.to_vec();
    depths.solve(&mut solved);
    solved
}

/// Step of all cameras: the solution of the Schur complement after the depths are eliminated.
fn poses(slopes: &[Slopes], mixed: &[Vec<f64>], solved: &[Vec<f64>], depth_step: &[f64]) -> Option<DVector<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut normal = DMatrix::from_fn(mixed.len(), mixed.len(), |i, j| -dot(&mixed[i], &solved[j]));
    let mut descent = DVector::from_fn(mixed.len(), |i, _| -dot(&mixed[i], depth_step));
    for (index, slopes) in slopes.iter().enumerate() {
        let from = index * PARAMETERS;
        let mut block = normal.fixed_view_mut::<PARAMETERS, PARAMETERS>(from, from);
        block += slopes.normal;
        let mut block = descent.fixed_rows_mut::<PARAMETERS>(from);
        block -= slopes.gradient;
    }
    normal.cholesky().map(|factor| factor.solve(&descent))
}
