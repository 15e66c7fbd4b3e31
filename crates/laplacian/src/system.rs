use glam::DVec3;
use nalgebra_sparse::CsrMatrix;
use nalgebra_sparse::csr::CsrRow;
use rosto_mesh::Topology;

use crate::gauge_fixed::{GaugeFixedForm, MANY_CONSTRAINED};
use crate::{AnchoredSystem, Constraints, LaplacianError, Operator, Response};

/// The part of δ-coordinate editing that depends on the mesh and operator alone.
///
/// An edit minimises `‖K X' − K X‖²` together with its constraints. The rest positions `X` drop out, so only the
/// displacement is solved for: `N = KᵀK + Σ wᵢeᵢeᵢᵀ`, `N g = wₑ·eₑ`, `X' = X + g Δᵀ`.
pub struct LaplacianSystem {
    operator: CsrMatrix<f64>,
    form: GaugeFixedForm,
}

impl LaplacianSystem {
    /// Builds `K` from the rest positions, in any unit, and factors `KᵀK`.
    ///
    /// # Errors
    /// The errors of [`Operator::matrix`] for invalid positions, and [`LaplacianError::BadlyScaled`] if the
    /// factorisation fails.
    pub fn new(topology: &Topology, positions: &[DVec3], operator: Operator) -> Result<Self, LaplacianError> {
        let operator = operator.matrix(topology, positions)?;
        let squared = operator.transpose() * &operator;
        Ok(Self { form: GaugeFixedForm::new(topology, &squared)?, operator })
    }

    /// The matrix `K`.
    pub fn operator(&self) -> &CsrMatrix<f64> {
        &self.operator
    }

    /// Returns the δ-coordinates `K X` of the given positions, in their unit.
    ///
    /// # Panics
    /// If the numbers of vertices and positions differ.
    pub fn deltas(&self, positions: &[DVec3]) -> Vec<DVec3> {
        assert_eq!(positions.len(), self.operator.ncols(), "one position for each vertex");
        let row = |row: CsrRow<'_, f64>| {
            let terms = row.col_indices().iter().zip(row.values());
            terms.map(|(&vertex, &weight)| weight * positions[vertex]).sum()
        };
        self.operator.row_iter().map(row).collect()
    }

    /// Returns a system with these anchors in its factorisation, or `None` for fewer than 64 anchors.
    ///
    /// From that number on, [`Self::respond`] factors again for each choice of handles, and the returned system does not.
    ///
    /// # Errors
    /// The errors of [`Self::respond`].
    pub fn anchored(&self, constraints: &Constraints<'_>) -> Result<Option<AnchoredSystem>, LaplacianError> {
        let are_many = constraints.anchors.len() >= MANY_CONSTRAINED;
        are_many.then(|| AnchoredSystem::new(&self.form, constraints)).transpose()
    }

    /// Returns the response of every vertex to the handles, with one solve per handle.
    ///
    /// # Errors
    /// If a constraint names a vertex outside the mesh, constraints contradict each other, or a component with a handle
    /// lacks an anchor.
    pub fn respond(&self, constraints: &Constraints<'_>) -> Result<Response, LaplacianError> {
        let constrained = self.form.constrain(constraints)?;
        let n = self.operator.nrows();
        let mut fields = vec![0.0; n * constraints.handles.len()];
        let mut targets = vec![0.0; constrained.constrained.len()];
        for (handle, field) in fields.chunks_exact_mut(n).enumerate() {
            targets[handle] = 1.0;
            constrained.minimise(&self.form, None, &targets, field)?;
            targets[handle] = 0.0;
        }
        Ok(Response::new(constraints, fields))
    }
}
