//! Constrained minimisation with one factorisation for all constraints.
//!
//! `Q` is a positive semi-definite form whose kernel is the functions that are constant on each component of the mesh.
//! This module factors `B = Q + Σ e_g e_gᵀ`, with one gauge vertex `g` per component. The choice of gauge does not
//! affect the results; it is the lowest vertex. Minimising `dᵀQd − 2rᵀd + Σ wᵢ(dᵢ − sᵢ)²` over constrained vertices
//! `S`, for a load `r` that sums to 0, then needs no other factorisation. With `Φ = B⁻¹`:
//! ```text
//! d = Φ r + Φ_S c + P t    with   ⎡ W⁻¹ + Φ_SS  P_S ⎤ ⎡ c ⎤ = ⎡ s − (Φ r)_S ⎤
//!                                 ⎣    P_Sᵀ      0  ⎦ ⎣ t ⎦   ⎣      0      ⎦
//! ```
//! where the columns of `P` are the indicators of the components. This is Woodbury's formula for `N = Q + Σ wᵢeᵢeᵢᵀ`,
//! with the gauge eliminated by `Φ e_g = P_g`, which holds because `Q·1 = 0`. A hard constraint has `1/w = 0`.

use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::dirichlet::Dirichlet;
use crate::factor::Factor;
use crate::saddle_point::SaddlePoint;
use crate::{ConstraintKind, Constraints, LaplacianError};

/// Number of constrained vertices from which they get a separate factorisation. For the 144 anchors of the oval at 7,257
/// vertices, it takes 16 ms, the saddle-point system 9 ms. But other handles with the same anchors then take 1 ms.
pub(crate) const MANY_CONSTRAINED: usize = 64;

/// The form `Q`, factored once for any constraints.
pub(crate) struct GaugeFixedForm {
    pub(crate) component: Vec<u32>,
    /// `B`.
    pub(crate) matrix: CsrMatrix<f64>,
    factor: Factor,
}

/// The form with its constraints fixed; targets and load remain free.
pub(crate) struct ConstrainedForm {
    /// The handles, then the anchors, in the order of the targets.
    pub(crate) constrained: Vec<u32>,
    pub(crate) kind: ConstraintKind,
    method: Method,
}

/// How a constrained form is minimised. Both methods solve the same problem.
enum Method {
    /// A saddle-point (KKT) system.
    SaddlePoint(SaddlePoint),
    /// A separate factorisation that contains the constraints.
    Dirichlet(Box<Dirichlet>),
}

impl GaugeFixedForm {
    pub(crate) fn new(topology: &Topology, form: &CsrMatrix<f64>) -> Result<Self, LaplacianError> {
        let component = topology.components();
        let matrix = gauge_fixed(form, &component);
        let factor = Factor::new(&matrix)?;
        Ok(Self { component, matrix, factor })
    }

    /// Checks the constraints and does the work that does not depend on targets.
    pub(crate) fn constrain(&self, constraints: &Constraints<'_>) -> Result<ConstrainedForm, LaplacianError> {
        constraints.check(&self.component)?;
        let (constrained, kind) = ([constraints.handles, constraints.anchors].concat(), constraints.kind);
        let method = if constrained.len() >= MANY_CONSTRAINED {
            Method::Dirichlet(Box::new(Dirichlet::new(&self.matrix, &self.component, &constrained, kind)?))
        } else {
            let entries = self.factor.inverse_among(&constrained);
            Method::SaddlePoint(SaddlePoint::new(&constrained, &self.component, kind, &entries))
        };
        Ok(ConstrainedForm { constrained, kind, method })
    }
}

impl ConstrainedForm {
    /// Writes the minimiser to `out`, for one target per constrained vertex and a load that sums to 0 over each
    /// component.
    pub(crate) fn minimise(
        &self,
        form: &GaugeFixedForm,
        load: Option<&[f64]>,
        targets: &[f64],
        out: &mut [f64],
    ) -> Result<(), LaplacianError> {
        match &self.method {
            Method::SaddlePoint(saddle_point) => {
                out.fill(0.0);
                if let Some(load) = load {
                    out.copy_from_slice(load);
                    form.factor.solve(out);
                }
                let missing =
                    self.constrained.iter().zip(targets).map(|(&vertex, target)| target - out[vertex as usize]);
                let c = saddle_point.solve(missing)?;
                let mut pulled = vec![0.0; out.len()];
                self.constrained.iter().zip(&c).for_each(|(&vertex, &c)| pulled[vertex as usize] = c);
                form.factor.solve(&mut pulled);
                out.iter_mut().zip(pulled).for_each(|(value, pulled)| *value += pulled);
                saddle_point.add_constants(&c, &form.component, out);
            }
            Method::Dirichlet(dirichlet) => dirichlet.minimise(load, targets, out, &mut dirichlet.factor.scratch(1)),
        }
        if self.kind == ConstraintKind::Hard {
            // The solve meets the targets up to rounding; assign them exactly.
            self.constrained.iter().zip(targets).for_each(|(&vertex, &target)| out[vertex as usize] = target);
        }
        Ok(())
    }
}

/// `Q + Σ e_g e_gᵀ`, with the lowest vertex of each component as its gauge vertex.
pub(crate) fn gauge_fixed(form: &CsrMatrix<f64>, component: &[u32]) -> CsrMatrix<f64> {
    let n = component.len();
    let mut gauges = CooMatrix::new(n, n);
    for vertex in (0..n).filter(|&vertex| component[vertex] as usize == vertex) {
        gauges.push(vertex, vertex, 1.0);
    }
    form + CsrMatrix::from(&gauges)
}
