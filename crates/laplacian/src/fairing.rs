use nalgebra_sparse::CsrMatrix;

use crate::{Factor, LaplacianError};

/// Smooths one value per vertex: [`Self::faired`] minimises `‖x − values‖² + weight·‖K x‖²` for an operator `K`
/// ([`Operator::matrix`](crate::Operator::matrix)). Factored once for any values.
///
/// Values in the kernel of `K`, such as constants, do not change.
pub struct Fairing {
    factor: Factor,
    vertices: usize,
}

impl Fairing {
    /// Factors `I + weight·KᵀK`.
    ///
    /// # Errors
    /// [`LaplacianError::Weight`] for a weight that is not positive and finite.
    pub fn new(operator: &CsrMatrix<f64>, weight: f64) -> Result<Self, LaplacianError> {
        if !(weight > 0.0 && weight.is_finite()) {
            return Err(LaplacianError::Weight { weight });
        }
        let vertices = operator.ncols();
        let bent = operator.transpose() * operator * weight;
        Ok(Self { factor: Factor::new(&(CsrMatrix::identity(vertices) + bent))?, vertices })
    }

    /// Returns the smoothed values, in the unit of `values`.
    ///
    /// # Errors
    /// [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for invalid values.
    pub fn faired(&self, values: &[f64]) -> Result<Vec<f64>, LaplacianError> {
        if values.len() != self.vertices {
            return Err(LaplacianError::LengthMismatch { expected: self.vertices, found: values.len() });
        }
        if let Some(vertex) = values.iter().position(|value| !value.is_finite()) {
            return Err(LaplacianError::NotFinite { vertex: vertex as u32 });
        }
        let mut faired = values.to_vec();
        self.factor.solve(&mut faired);
        Ok(faired)
    }
}
