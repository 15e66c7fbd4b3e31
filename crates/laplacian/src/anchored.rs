use nalgebra::DMatrix;

use crate::dirichlet::Dirichlet;
use crate::gauge_fixed::GaugeFixedForm;
use crate::{Constraints, LaplacianError, Response};

/// A system whose anchors are worked into the factor, so that any handles beside them ask for no new one.
///
/// With `A = Q + Σ` of the anchors alone and `U = A⁻¹E` of the handles, the fields are `U (W⁻¹ + EᵀU)⁻¹`, Woodbury's formula
/// once more; a hard constraint is `1/w = 0`.
pub struct AnchoredSystem {
    component: Vec<u32>,
    anchors: Dirichlet,
}

impl AnchoredSystem {
    pub(crate) fn new(form: &GaugeFixedForm, constraints: &Constraints<'_>) -> Result<Self, LaplacianError> {
        constraints.check(&form.component)?;
        let anchors = Dirichlet::new(&form.matrix, &form.component, constraints.anchors, constraints.kind)?;
        Ok(Self { component: form.component.clone(), anchors })
    }

    /// How every vertex follows the handles: one solve for each. Anchors and kind must be those that this was made for.
    ///
    /// # Errors
    /// As for [`LaplacianSystem::respond`](crate::LaplacianSystem::respond).
    ///
    /// # Panics
    /// If anchors or kind are others.
    pub fn respond(&self, constraints: &Constraints<'_>) -> Result<Response, LaplacianError> {
        assert!(self.anchors.holds(constraints.anchors, constraints.kind), "the anchors that the system was made for");
        constraints.check(&self.component)?;
        let (n, handles) = (self.component.len(), constraints.handles);
        let mut columns = DMatrix::zeros(n, handles.len());
        for (mut column, &handle) in columns.column_iter_mut().zip(handles) {
            column[handle as usize] = 1.0;
            self.anchors.factor.solve(column.as_mut_slice());
        }
        let mut between = DMatrix::from_fn(handles.len(), handles.len(), |i, j| columns[(handles[i] as usize, j)]);
        (0..handles.len()).for_each(|i| between[(i, i)] += constraints.kind.compliance());
        let shares = between.lu().try_inverse().ok_or(LaplacianError::BadlyScaled { vertex: handles[0] })?;
        let mut fields = columns * shares;
        if fields.iter().any(|share| !share.is_finite()) {
            return Err(LaplacianError::BadlyScaled { vertex: handles[0] });
        }
        if constraints.kind == crate::ConstraintKind::Hard {
            // Exact up to rounding so far; now to the last bit.
            for (i, mut field) in fields.column_iter_mut().enumerate() {
                handles
                    .iter()
                    .enumerate()
                    .for_each(|(j, &handle)| field[handle as usize] = f64::from(u8::from(i == j)));
                constraints.anchors.iter().for_each(|&anchor| field[anchor as usize] = 0.0);
            }
        }
        Ok(Response::new(constraints, fields.data.into()))
    }
}
