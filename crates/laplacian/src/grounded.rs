//! Constrained minimisation with one factor for all constraints.
//!
//! Of a positive semi-definite form `Q`, whose kernel is the constants on each component of the mesh, the factor of
//! `B = Q + Σ e_g e_gᵀ` is kept, with one ground vertex `g` for each component. Minimising
//! `dᵀQd − 2rᵀd + Σ wᵢ(dᵢ − sᵢ)²` over held vertices `S`, for a load `r` that sums to 0, then asks for no new factor.
//! With `Φ = B⁻¹`:
//! ```text
//! d = Φ r + Φ_S c + P t    with   ⎡ W⁻¹ + Φ_SS  P_S ⎤ ⎡ c ⎤ = ⎡ s − (Φ r)_S ⎤
//!                                 ⎣    P_Sᵀ      0  ⎦ ⎣ t ⎦   ⎣      0      ⎦
//! ```
//! where `P` holds the indicators of the components. This is Woodbury's formula for `N = Q + Σ wᵢeᵢeᵢᵀ`, with the ground
//! taken out by `Φ e_g = P_g` (as `Q·1 = 0`), so that the choice of ground leaves no trace. An exact hold is `1/w = 0`.

use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::bordered::Bordered;
use crate::eliminated::Eliminated;
use crate::factor::{Factor, HalfSolved};
use crate::{Constraints, Hold, LaplacianError};

/// From this many held vertices on, a factor of their own is cheaper than the bordered system, which grows as the cube.
pub(crate) const MANY_HELD: usize = 256;

/// The form `Q`, factored once in a way that serves any constraints.
pub(crate) struct GroundedForm {
    component: Vec<u32>,
    /// `B`.
    matrix: CsrMatrix<f64>,
    factor: Factor,
}

/// The form under constraints: what is left to choose are targets and load.
pub(crate) struct HeldForm {
    held: Vec<u32>,
    hold: Hold,
    way: Way,
}

/// How a held form is minimised; both ways give the same numbers.
enum Way {
    /// The columns `Φ_S` are half solved, and the rest of the work is a bordered system.
    Bordered(Vec<HalfSolved>, Bordered),
    /// The held vertices are worked into a factor of their own.
    Eliminated(Box<Eliminated>),
}

impl GroundedForm {
    pub(crate) fn new(topology: &Topology, form: &CsrMatrix<f64>) -> Result<Self, LaplacianError> {
        let component = topology.components();
        let matrix = grounded(form, &component);
        let factor = Factor::new(&matrix)?;
        Ok(Self { component, matrix, factor })
    }

    pub(crate) fn component(&self) -> &[u32] {
        &self.component
    }

    /// `B`.
    pub(crate) fn matrix(&self) -> &CsrMatrix<f64> {
        &self.matrix
    }

    /// Checks the constraints and does all the work that does not depend on targets.
    pub(crate) fn hold(&self, constraints: &Constraints<'_>) -> Result<HeldForm, LaplacianError> {
        constraints.check(&self.component)?;
        let (held, hold) = (constraints.held(), constraints.hold);
        let way = if held.len() >= MANY_HELD {
            Way::Eliminated(Box::new(Eliminated::new(&self.matrix, &self.component, &held, hold)?))
        } else {
            let halves = self.factor.half_solve(&held);
            let entry = |i: usize, j: usize| self.factor.inverse_entry(&halves[i], &halves[j]);
            let bordered = Bordered::new(&held, &self.component, hold, entry);
            Way::Bordered(halves, bordered)
        };
        Ok(HeldForm { held, hold, way })
    }
}

impl HeldForm {
    /// The vertices that `targets` belong to: handles, then anchors.
    pub(crate) fn held(&self) -> &[u32] {
        &self.held
    }

    pub(crate) fn hold(&self) -> Hold {
        self.hold
    }

    pub(crate) fn is_exact(&self) -> bool {
        self.hold == Hold::Exact
    }

    /// Writes the minimiser for one target for each held vertex, and a load that sums to 0 over each component.
    pub(crate) fn minimise(
        &self,
        form: &GroundedForm,
        load: Option<&[f64]>,
        targets: &[f64],
        out: &mut [f64],
    ) -> Result<(), LaplacianError> {
        match &self.way {
            Way::Bordered(halves, bordered) => {
                let mut rows = load.map_or_else(|| vec![0.0; out.len()], |load| form.factor.forward(load));
                let rest =
                    halves.iter().zip(targets).map(|(half, target)| target - form.factor.inverse_row(half, &rows));
                let c = bordered.solve(rest)?;
                halves.iter().zip(&c.columns).for_each(|(half, &c)| form.factor.add(half, c, &mut rows));
                form.factor.backward(rows, out);
                c.add_constants(&form.component, out);
            }
            Way::Eliminated(eliminated) => eliminated.minimise(load, targets, out),
        }
        if self.is_exact() {
            // Exact up to rounding so far; now to the last bit.
            self.held.iter().zip(targets).for_each(|(&vertex, &target)| out[vertex as usize] = target);
        }
        Ok(())
    }
}

/// `Q + Σ e_g e_gᵀ`; the ground of a component is its lowest vertex.
pub(crate) fn grounded(form: &CsrMatrix<f64>, component: &[u32]) -> CsrMatrix<f64> {
    let n = component.len();
    let mut grounds = CooMatrix::new(n, n);
    for vertex in (0..n).filter(|&vertex| component[vertex] as usize == vertex) {
        grounds.push(vertex, vertex, 1.0);
    }
    form + CsrMatrix::from(&grounds)
}
