use nalgebra_sparse::CsrMatrix;

use crate::{Factor, LaplacianError};

/// Values near to those given, one for each vertex, that bend less: the minimum of `‖x − values‖² + weight·‖K x‖²` for an
/// operator `K` ([`Operator::matrix`](crate::Operator::matrix)), in the unit of the values. One factorisation.
///
/// What `K` takes no notice of, such as a constant, stays as it is.
///
/// # Errors
/// [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for values that do not fit, and
/// [`LaplacianError::Weight`] for a weight that is not positive and finite.
pub fn faired(operator: &CsrMatrix<f64>, values: &[f64], weight: f64) -> Result<Vec<f64>, LaplacianError> {
    let n = operator.ncols();
    if values.len() != n {
        return Err(LaplacianError::LengthMismatch { expected: n, found: values.len() });
    }
    if let Some(vertex) = values.iter().position(|value| !value.is_finite()) {
        return Err(LaplacianError::NotFinite { vertex: vertex as u32 });
    }
    if !(weight > 0.0 && weight.is_finite()) {
        return Err(LaplacianError::Weight { weight });
    }
    let bent = operator.transpose() * operator * weight;
    let mut faired = values.to_vec();
    Factor::new(&(CsrMatrix::identity(n) + bent))?.solve(&mut faired);
    Ok(faired)
}
