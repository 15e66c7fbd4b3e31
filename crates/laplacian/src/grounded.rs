use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::bordered::Bordered;
use crate::factor::{Factor, HalfSolved};
use crate::kernels::subtract_scaled;
use crate::{Constraints, Hold, LaplacianError, Response};

/// Meshes of up to this many vertices keep the whole of `Φ`, so that a handle is selected without any solve.
const WHOLE_INVERSE_LIMIT: usize = 1000;

/// A positive semi-definite form `Q` whose kernel is the constants on each component of the mesh, factored once in a way
/// that serves any constraints.
///
/// What is kept is `Φ = B⁻¹` for `B = Q + Σ e_g e_gᵀ`, with one ground vertex `g` for each component: as a sparse factor,
/// or whole where the mesh is small. Minimising `dᵀQd + Σ wᵢ(dᵢ − sᵢ)²` over held vertices `S` then asks for no new factor:
/// ```text
/// d = Φ_S c + P t       with   ⎡ W⁻¹ + Φ_SS  P_S ⎤ ⎡ c ⎤ = ⎡ s ⎤
///                              ⎣    P_Sᵀ      0  ⎦ ⎣ t ⎦   ⎣ 0 ⎦
/// ```
/// where `P` holds the indicators of the components. This is Woodbury's formula for `N = Q + Σ wᵢeᵢeᵢᵀ`, with the ground
/// taken out by `Φ e_g = P_g` (as `Q·1 = 0`), so that the choice of ground leaves no trace. An exact hold is `1/w = 0`.
pub(crate) struct GroundedForm {
    component: Vec<u32>,
    factor: Factor,
    /// The columns of `Φ`, end to end.
    whole: Option<Vec<f64>>,
}

/// The columns of `Φ` that belong to the held vertices.
enum Columns<'a> {
    Whole(Vec<&'a [f64]>),
    Half(&'a Factor, Vec<HalfSolved>),
}

impl GroundedForm {
    pub(crate) fn new(topology: &Topology, form: &CsrMatrix<f64>) -> Result<Self, LaplacianError> {
        let component = topology.components();
        let factor = Factor::new(&grounded(form, &component))?;
        let whole = (component.len() <= WHOLE_INVERSE_LIMIT).then(|| whole_inverse(&factor, component.len()));
        Ok(Self { component, factor, whole })
    }

    /// One field for each handle: the minimiser for target 1 at that handle and 0 at everything else that is held.
    pub(crate) fn respond(&self, constraints: &Constraints<'_>) -> Result<Response, LaplacianError> {
        constraints.check(&self.component)?;
        let held = constraints.held();
        let columns = self.columns(&held);
        let bordered =
            Bordered::new(&held, &self.component, constraints.hold.compliance(), |i, j| columns.entry(&held, i, j));
        let n = self.component.len();
        let mut fields = vec![0.0; n * constraints.handles.len()];
        for (index, field) in fields.chunks_exact_mut(n).enumerate() {
            let coefficients = bordered.solve(index)?;
            columns.combine(&coefficients.columns, field);
            coefficients.add_constants(&self.component, field);
            if constraints.hold == Hold::Exact {
                // Exact up to rounding so far; now to the last bit.
                held.iter().for_each(|&vertex| field[vertex as usize] = 0.0);
                field[held[index] as usize] = 1.0;
            }
        }
        Ok(Response::new(constraints, fields))
    }

    fn columns(&self, held: &[u32]) -> Columns<'_> {
        let n = self.component.len();
        match &self.whole {
            Some(whole) => Columns::Whole(held.iter().map(|&v| &whole[v as usize * n..(v as usize + 1) * n]).collect()),
            None => {
                let mut work = vec![0.0; n];
                Columns::Half(&self.factor, held.iter().map(|&v| self.factor.half_solve(v, &mut work)).collect())
            }
        }
    }
}

impl Columns<'_> {
    /// `Φ_SS` at row `i`, column `j`.
    fn entry(&self, held: &[u32], i: usize, j: usize) -> f64 {
        match self {
            Self::Whole(columns) => columns[j][held[i] as usize],
            Self::Half(factor, halves) => factor.inverse_entry(&halves[i], &halves[j]),
        }
    }

    /// Writes `Φ_S c` to `field`.
    fn combine(&self, coefficients: &[f64], field: &mut [f64]) {
        match self {
            Self::Whole(columns) => {
                field.fill(0.0);
                columns.iter().zip(coefficients).for_each(|(column, &c)| subtract_scaled(field, -c, column));
            }
            Self::Half(factor, halves) => factor.finish(halves.iter().zip(coefficients.iter().copied()), field),
        }
    }
}

/// `Q + Σ e_g e_gᵀ`; the ground of a component is its lowest vertex.
fn grounded(form: &CsrMatrix<f64>, component: &[u32]) -> CsrMatrix<f64> {
    let n = component.len();
    let mut grounds = CooMatrix::new(n, n);
    for vertex in (0..n).filter(|&vertex| component[vertex] as usize == vertex) {
        grounds.push(vertex, vertex, 1.0);
    }
    form + CsrMatrix::from(&grounds)
}

fn whole_inverse(factor: &Factor, n: usize) -> Vec<f64> {
    let mut inverse = vec![0.0; n * n];
    let mut work = vec![0.0; n];
    for (vertex, column) in inverse.chunks_exact_mut(n.max(1)).enumerate() {
        let half = factor.half_solve(vertex as u32, &mut work);
        factor.finish(std::iter::once((&half, 1.0)), column);
    }
    inverse
}
