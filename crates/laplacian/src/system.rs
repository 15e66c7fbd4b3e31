use glam::DVec3;
use nalgebra_sparse::CsrMatrix;
use nalgebra_sparse::csr::CsrRow;
use rosto_mesh::Topology;

use crate::gauge_fixed::{GaugeFixedForm, MANY_CONSTRAINED};
use crate::{AnchoredSystem, Constraints, LaplacianError, Operator, Response};

/// Everything about δ-coordinate edits that depends on the mesh and operator alone; built once.
///
/// An edit minimises `‖K X' − K X‖²` together with its constraints. `X` itself leaves nothing of that where nothing is
/// moved, so only the displacement is solved for: `N = KᵀK + Σ wᵢeᵢeᵢᵀ`, `N g = wₑ·eₑ`, `X' = X + g Δᵀ`.
pub struct LaplacianSystem {
    operator: CsrMatrix<f64>,
    form: GaugeFixedForm,
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
        Ok(Self { form: GaugeFixedForm::new(topology, &squared)?, operator })
    }

    /// The matrix `K`.
    pub fn operator(&self) -> &CsrMatrix<f64> {
        &self.operator
    }

    /// The δ-coordinates `K X` of some positions, in their unit.
    ///
    /// # Panics
    /// If there is not one position for each vertex.
    pub fn deltas(&self, positions: &[DVec3]) -> Vec<DVec3> {
        assert_eq!(positions.len(), self.operator.ncols(), "one position for each vertex");
        let row = |row: CsrRow<'_, f64>| {
            let terms = row.col_indices().iter().zip(row.values());
            terms.map(|(&vertex, &weight)| weight * positions[vertex]).sum()
        };
        self.operator.row_iter().map(row).collect()
    }

    /// A system of its own for these anchors, where they are so many that [`Self::respond`] would factor anew for all
    /// handles; it serves other handles, too.
    ///
    /// # Errors
    /// As for [`Self::respond`].
    pub fn anchored(&self, constraints: &Constraints<'_>) -> Result<Option<AnchoredSystem>, LaplacianError> {
        let are_many = constraints.anchors.len() >= MANY_CONSTRAINED;
        are_many.then(|| AnchoredSystem::new(&self.form, constraints)).transpose()
    }

    /// How every vertex follows the handles: one back-substitution for each handle.
    ///
    /// # Errors
    /// For constraints that name no vertex, contradict each other, or leave a handle's piece of the mesh unanchored.
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
