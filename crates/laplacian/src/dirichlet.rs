use nalgebra_sparse::{CooMatrix, CsrMatrix};

use crate::factor::{Factor, Scratch};
use crate::{ConstraintKind, LaplacianError};

/// A form that is factored with its constraints, for any number of constrained vertices.
///
/// Soft constraints add their weight to the diagonal. Hard constraints use Dirichlet elimination: the rows and columns
/// of the constrained vertices become the identity's, and their coupling to free vertices moves to the right-hand side.
pub(crate) struct Dirichlet {
    constrained: Vec<u32>,
    kind: ConstraintKind,
    pub(crate) factor: Factor,
    /// For hard constraints, the entries between free vertices (rows) and constrained vertices (indices into
    /// `constrained`).
    pull: Vec<(usize, usize, f64)>,
}

impl Dirichlet {
    /// Removes the gauge from `B = Q + Σ e_g e_gᵀ` in every constrained component, adds the constraints, and factors.
    pub(crate) fn new(
        gauge_fixed: &CsrMatrix<f64>,
        component: &[u32],
        constrained: &[u32],
        kind: ConstraintKind,
    ) -> Result<Self, LaplacianError> {
        let n = component.len();
        let mut index = vec![None; n];
        constrained.iter().enumerate().for_each(|(k, &vertex)| index[vertex as usize] = Some(k));
        let mut touched = vec![false; n];
        constrained.iter().for_each(|&vertex| touched[component[vertex as usize] as usize] = true);

        let mut entries = CooMatrix::new(n, n);
        let mut pull = Vec::new();
        for (i, j, &value) in gauge_fixed.triplet_iter() {
            let ground = if i == j && touched[i] { 1.0 } else { 0.0 };
            match (kind, index[i], index[j]) {
                (ConstraintKind::Soft { weight }, Some(_), _) if i == j => entries.push(i, j, value - ground + weight),
                (ConstraintKind::Hard, Some(_), _) if i == j => entries.push(i, j, 1.0),
                (ConstraintKind::Hard, None, Some(k)) => pull.push((i, k, value)),
                (ConstraintKind::Hard, Some(_), _) => {}
                _ => entries.push(i, j, value - ground),
            }
        }
        Ok(Self { constrained: constrained.to_vec(), kind, factor: Factor::new(&CsrMatrix::from(&entries))?, pull })
    }

    /// Whether the form has exactly these constraints.
    pub(crate) fn has_constraints(&self, constrained: &[u32], kind: ConstraintKind) -> bool {
        self.constrained == constrained && self.kind == kind
    }

    /// See [`ConstrainedForm::minimise`](crate::gauge_fixed::ConstrainedForm::minimise). `load`, `targets` and `out` can
    /// hold several columns one after the other.
    pub(crate) fn minimise(&self, load: Option<&[f64]>, targets: &[f64], out: &mut [f64], scratch: &mut Scratch) {
        match load {
            Some(load) => out.copy_from_slice(load),
            None => out.fill(0.0),
        }
        let columns = targets.len() / self.constrained.len();
        let rows = out.len() / columns;
        for (out, targets) in out.chunks_exact_mut(rows).zip(targets.chunks_exact(self.constrained.len())) {
            self.constrain(targets, out);
        }
        self.factor.solve_in(out, scratch);
    }

    /// Adds the constraints to the right-hand side.
    fn constrain(&self, targets: &[f64], out: &mut [f64]) {
        for (&vertex, target) in self.constrained.iter().zip(targets) {
            match self.kind {
                ConstraintKind::Soft { weight } => out[vertex as usize] += weight * target,
                ConstraintKind::Hard => out[vertex as usize] = *target,
            }
        }
        for &(free, constrained, value) in &self.pull {
            out[free] -= value * targets[constrained];
        }
    }
}
