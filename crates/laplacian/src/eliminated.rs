use nalgebra_sparse::{CooMatrix, CsrMatrix};

use crate::factor::Factor;
use crate::{Hold, LaplacianError};

/// A form whose held vertices are worked into the matrix before it is factored, however many they are.
///
/// Soft holds add their weight to the diagonal. Exactly held vertices leave the system: their rows and columns become the
/// identity's, and what they pull on their neighbours moves to the right-hand side.
pub(crate) struct Eliminated {
    held: Vec<u32>,
    hold: Hold,
    factor: Factor,
    /// For exact holds, the entries between free vertices (rows) and held ones (by index into `held`).
    pull: Vec<(usize, usize, f64)>,
}

impl Eliminated {
    /// From `B = Q + Σ e_g e_gᵀ`, where the ground of a component is the vertex that names it.
    pub(crate) fn new(
        grounded: &CsrMatrix<f64>,
        component: &[u32],
        held: &[u32],
        hold: Hold,
    ) -> Result<Self, LaplacianError> {
        let n = component.len();
        let mut index = vec![None; n];
        held.iter().enumerate().for_each(|(k, &vertex)| index[vertex as usize] = Some(k));
        let mut touched = vec![false; n];
        held.iter().for_each(|&vertex| touched[component[vertex as usize] as usize] = true);

        let mut entries = CooMatrix::new(n, n);
        let mut pull = Vec::new();
        for (i, j, &value) in grounded.triplet_iter() {
            let ground = if i == j && touched[i] { 1.0 } else { 0.0 };
            match (hold, index[i], index[j]) {
                (Hold::Soft { weight }, Some(_), _) if i == j => entries.push(i, j, value - ground + weight),
                (Hold::Exact, Some(_), _) if i == j => entries.push(i, j, 1.0),
                (Hold::Exact, None, Some(k)) => pull.push((i, k, value)),
                (Hold::Exact, Some(_), _) => {}
                _ => entries.push(i, j, value - ground),
            }
        }
        Ok(Self { held: held.to_vec(), hold, factor: Factor::new(&CsrMatrix::from(&entries))?, pull })
    }

    /// Whether these vertices, and no others, are held so.
    pub(crate) fn holds(&self, held: &[u32], hold: Hold) -> bool {
        self.held == held && self.hold == hold
    }

    /// Solves for a load on free vertices, in place.
    pub(crate) fn solve(&self, load: &mut [f64]) {
        self.factor.solve(load);
    }

    /// See [`HeldForm::minimise`](crate::grounded::HeldForm::minimise).
    pub(crate) fn minimise(&self, load: Option<&[f64]>, targets: &[f64], out: &mut [f64]) {
        match load {
            Some(load) => out.copy_from_slice(load),
            None => out.fill(0.0),
        }
        for (&vertex, target) in self.held.iter().zip(targets) {
            match self.hold {
                Hold::Soft { weight } => out[vertex as usize] += weight * target,
                Hold::Exact => out[vertex as usize] = *target,
            }
        }
        for &(free, held, value) in &self.pull {
            out[free] -= value * targets[held];
        }
        self.factor.solve(out);
    }
}
