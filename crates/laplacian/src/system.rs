use glam::DVec3;
use nalgebra_sparse::CsrMatrix;
use rosto_mesh::Topology;

use crate::grounded::GroundedForm;
use crate::{Constraints, LaplacianError, Operator, Response};

/// Everything about δ-coordinate edits that depends on the mesh and operator alone; built once.
///
/// An edit minimises `‖K X' − K X‖²` together with its constraints. `X` itself leaves nothing of that where nothing is
/// moved, so only the displacement is solved for: `N = KᵀK + Σ wᵢeᵢeᵢᵀ`, `N g = wₑ·eₑ`, `X' = X + g Δᵀ`.
pub struct LaplacianSystem {
    operator: CsrMatrix<f64>,
    form: GroundedForm,
}

impl LaplacianSystem {
    /// Builds `K` over the mesh at rest and factors `KᵀK`. `positions` in any unit.
    ///
    /// # Errors
    /// For positions that do not fit the mesh or are not finite, and [`LaplacianError::BadlyScaled`] should the factor
    /// break down.
    pub fn new(topology: &Topology, positions: &[DVec3], operator: Operator) -> Result<Self, LaplacianError> {
        let operator = operator.matrix(topology, positions)?;
        let squared = operator.transpose() * &operator;
        Ok(Self { form: GroundedForm::new(topology, &squared)?, operator })
    }

    /// The matrix `K`.
    pub fn operator(&self) -> &CsrMatrix<f64> {
        &self.operator
    }

    /// How every vertex follows the handles: one back-substitution for each handle, or none on a small mesh.
    ///
    /// # Errors
    /// For constraints that name no vertex, contradict each other, or leave a handle's piece of the mesh unanchored.
    pub fn respond(&self, constraints: &Constraints<'_>) -> Result<Response, LaplacianError> {
        self.form.respond(constraints)
    }
}
