use nalgebra::{DMatrix, DVector, Dyn, LU};

use crate::{ConstraintKind, LaplacianError};

/// The saddle-point (KKT) system of the constrained vertices, after elimination of the free ones; see
/// [`crate::gauge_fixed`].
pub(crate) struct SaddlePoint {
    constrained: Vec<u32>,
    /// The components that contain a constrained vertex.
    touched: Vec<u32>,
    system: LU<f64, Dyn, Dyn>,
}

impl SaddlePoint {
    /// `entries` is `Φ_SS`.
    pub(crate) fn new(constrained: &[u32], component: &[u32], kind: ConstraintKind, entries: &DMatrix<f64>) -> Self {
        let mut touched: Vec<u32> = constrained.iter().map(|&vertex| component[vertex as usize]).collect();
        touched.sort_unstable();
        touched.dedup();
        let k = constrained.len();
        let mut system = DMatrix::zeros(k + touched.len(), k + touched.len());
        system.view_mut((0, 0), (k, k)).copy_from(entries);
        for j in 0..k {
            system[(j, j)] += kind.compliance();
            let own = k + touched.partition_point(|&other| other < component[constrained[j] as usize]);
            (system[(own, j)], system[(j, own)]) = (1.0, 1.0);
        }
        Self { constrained: constrained.to_vec(), touched, system: system.lu() }
    }

    /// Returns the coefficients of the columns of `Φ`, then the constants of the touched components, for one target per
    /// constrained vertex.
    pub(crate) fn solve(&self, targets: impl Iterator<Item = f64>) -> Result<DVector<f64>, LaplacianError> {
        let size = self.constrained.len() + self.touched.len();
        let mut x = DVector::from_iterator(size, targets.chain(std::iter::repeat(0.0)).take(size));
        if !self.system.solve_mut(&mut x) || x.iter().any(|value| !value.is_finite()) {
            return Err(LaplacianError::BadlyScaled { vertex: self.constrained[0] });
        }
        Ok(x)
    }

    /// Adds `P t` of a solution from [`Self::solve`] to `field`.
    pub(crate) fn add_constants(&self, coefficients: &DVector<f64>, component: &[u32], field: &mut [f64]) {
        for (touched, constant) in self.touched.iter().zip(&coefficients.as_slice()[self.constrained.len()..]) {
            for (value, component) in field.iter_mut().zip(component) {
                if component == touched {
                    *value += constant;
                }
            }
        }
    }
}
