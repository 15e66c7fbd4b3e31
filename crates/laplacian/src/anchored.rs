use nalgebra::DMatrix;

use crate::dirichlet::Dirichlet;
use crate::gauge_fixed::GaugeFixedForm;
use crate::{Constraints, LaplacianError, Response};

/// A system with its anchors in the factorisation, so that changing the handles needs no other factorisation.
///
/// With `A = Q + Σ wₐeₐeₐᵀ` over the anchors and `U = A⁻¹E` for the handles' unit vectors `E`, the response fields are
/// `U (W⁻¹ + EᵀU)⁻¹` by Woodbury's formula. A hard constraint has `1/w = 0`.
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

    /// Returns the response of every vertex to the handles, with one solve per handle. `anchors` and `kind` must equal
    /// those of the system.
    ///
    /// # Errors
    /// The errors of [`LaplacianSystem::respond`](crate::LaplacianSystem::respond).
    ///
    /// # Panics
    /// If `anchors` or `kind` differ from those of the system.
    pub fn respond(&self, constraints: &Constraints<'_>) -> Result<Response, LaplacianError> {
        assert!(
            self.anchors.has_constraints(constraints.anchors, constraints.kind),
            "anchors and kind equal those of the system"
        );
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
            // The solve meets the constraints up to rounding; assign them exactly.
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
