use nalgebra_sparse::CsrMatrix;

use crate::{Factor, LaplacianError};

/// Makes values, one for each vertex, bend less: [`Self::faired`] is the minimum of `‖x − values‖² + weight·‖K x‖²` for an
/// operator `K` ([`Operator::matrix`](crate::Operator::matrix)), in the unit of the values. Factored once, for any values.
///
/// What `K` takes no notice of, such as a constant, stays as it is.
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

    /// Values near to those given that bend less.
    ///
    /// # Errors
    /// [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for values that do not fit.
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
