//! The depths of the photo that leads and the cameras of all others, found together.

use nalgebra::{DMatrix, DVector};
use nalgebra_sparse::CsrMatrix;
use rosto_laplacian::{Factor, Operator};

use super::beside::{Beside, Slopes};
use super::drawn::Rays;
use super::seat::PARAMETERS;
use crate::{FaceError, LANDMARK_COUNT, Triangulation};

/// The depths of the photo that leads are off by about so much, and their δ-coordinates by so much.
const DEPTH_M: f64 = 0.02;
const DELTA_M: f64 = 0.000_15;

/// The minimum of
///
/// `Σₖ Σᵢ wₖᵢ ρ(|πₖ(xᵢ + (zᵢ + dᵢ) rᵢ) − sₖᵢ| / σₖ) + |z / DEPTH_M|² + |L z / DELTA_M|²`
///
/// over how much nearer each landmark comes to the camera of the photo that leads (z, in m) and the seats of the others (π),
/// where x is the shape by that photo alone, r its rays, d how far the network draws parts of the face out, s what the others
/// show, ρ(e) = 2(√(1 + e²) − 1), and L the random-walk graph Laplacian. By Gauss and Newton with weights; in each step the depths are eliminated first, whose part of the normal
/// matrix is as sparse as the mesh.
pub(super) struct Joint<'a> {
    rays: &'a Rays,
    /// What holds the depths beside the photos.
    held: CsrMatrix<f64>,
}

impl<'a> Joint<'a> {
    pub(super) fn new(rays: &'a Rays) -> Result<Self, FaceError> {
        let operator = Operator::Uniform.matrix(&Triangulation::Canonical.topology(), &rays.places_m);
        let operator = operator.map_err(|_| FaceError::Degenerate)?;
        let bent = operator.transpose() * &operator * (1.0 / (DELTA_M * DELTA_M));
        let held = CsrMatrix::identity(LANDMARK_COUNT) * (1.0 / (DEPTH_M * DEPTH_M)) + bent;
        Ok(Self { rays, held })
    }

    /// How much nearer each landmark comes, with the others' seats.
    pub(super) fn settle(&self, others: &mut [Beside]) -> Result<Vec<f64>, FaceError> {
        const MOST_STEPS: usize = 100;
        const ENOUGH_M: f64 = 1e-12;
        let mut nearer_m = vec![0.0; LANDMARK_COUNT];
        for _ in 0..MOST_STEPS {
            let step_m = self.step(others, &nearer_m)?;
            nearer_m.iter_mut().zip(&step_m).for_each(|(nearer_m, step_m)| *nearer_m += step_m);
            let furthest_m = step_m.iter().fold(0.0, |most: f64, step_m| most.max(step_m.abs()));
            if !furthest_m.is_finite() {
                return Err(FaceError::Degenerate);
            }
            if furthest_m < ENOUGH_M {
                break;
            }
        }
        Ok(nearer_m)
    }

    /// One step of all: takes that of the seats, and returns that of the depths.
    fn step(&self, others: &mut [Beside], nearer_m: &[f64]) -> Result<Vec<f64>, FaceError> {
        let drawn_m = self.rays.drawn_nearer_m(nearer_m);
        others.iter_mut().for_each(|other| other.weigh(&drawn_m));
        let slopes: Vec<Slopes> = others.iter().map(|other| other.slopes(&drawn_m, &self.rays.ways)).collect();
        let depths = self.factor(&slopes)?;
        let mut towards = self.pull(&slopes, nearer_m);
        depths.solve(&mut towards);
        let mixed = mixed(&slopes);
        let solved: Vec<Vec<f64>> = mixed.iter().map(|column| solved(&depths, column)).collect();
        let seats = seats(&slopes, &mixed, &solved, &towards).ok_or(FaceError::Degenerate)?;
        for (other, step) in others.iter_mut().zip(seats.as_slice().chunks_exact(PARAMETERS)) {
            other.seat.take(&super::seat::Parameters::from_column_slice(step));
        }
        for (column, step) in solved.iter().zip(seats.iter()) {
            towards.iter_mut().zip(column).for_each(|(towards, value)| *towards -= value * step);
        }
        Ok(towards)
    }

    fn factor(&self, slopes: &[Slopes]) -> Result<Factor, FaceError> {
        let mut normal = self.held.clone();
        for (row, column, value) in normal.triplet_iter_mut() {
            if row == column {
                *value += slopes.iter().map(|of| of.depths[row].0).sum::<f64>();
            }
        }
        Factor::new(&normal).map_err(|_| FaceError::Degenerate)
    }

    /// Minus the gradient by the depths.
    fn pull(&self, slopes: &[Slopes], nearer_m: &[f64]) -> Vec<f64> {
        let held = &self.held * &DVector::from_column_slice(nearer_m);
        let of = |landmark: usize| slopes.iter().map(|of| of.depths[landmark].1).sum::<f64>();
        held.iter().enumerate().map(|(landmark, held)| -held - of(landmark)).collect()
    }
}

/// The products of the slopes by the depths and by each parameter of the seats.
fn mixed(slopes: &[Slopes]) -> Vec<Vec<f64>> {
    let columns = slopes.iter().flat_map(|of| (0..PARAMETERS).map(move |parameter| (of, parameter)));
    columns.map(|(of, parameter)| of.depths.iter().map(|depth| depth.2[parameter]).collect()).collect()
}

fn solved(depths: &Factor, column: &[f64]) -> Vec<f64> {
    let mut solved = column.to_vec();
    depths.solve(&mut solved);
    solved
}

/// The step of all seats, of the normal matrix that is left when the depths are eliminated.
fn seats(slopes: &[Slopes], mixed: &[Vec<f64>], solved: &[Vec<f64>], towards: &[f64]) -> Option<DVector<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut normal = DMatrix::from_fn(mixed.len(), mixed.len(), |i, j| -dot(&mixed[i], &solved[j]));
    let mut pull = DVector::from_fn(mixed.len(), |i, _| -dot(&mixed[i], towards));
    for (index, of) in slopes.iter().enumerate() {
        let from = index * PARAMETERS;
        let mut own = normal.fixed_view_mut::<PARAMETERS, PARAMETERS>(from, from);
        own += of.normal;
        let mut own = pull.fixed_rows_mut::<PARAMETERS>(from);
        own -= of.gradient;
    }
    normal.cholesky().map(|factor| factor.solve(&pull))
}
