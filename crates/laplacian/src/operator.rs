use glam::DVec3;
use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::{LaplacianError, check_positions, weights};

rosto_mesh::named! {
    /// A discrete Laplacian `K`, which turns positions into δ-coordinates: `δ = K x`.
    ///
    /// Every operator is `n × n`, dimensionless (no matter the unit of the positions), positive on the diagonal, has rows that
    /// sum to 0, and so takes no notice of translations; `δᵢ` points from a weighted mean of the neighbours to vertex `i`.
    /// Each is made of edge weights `W`: `L = diag(W·1) − W` is symmetric and positive semi-definite, with one zero eigenvalue
    /// for each component of the mesh. `K` is `L` itself, or `L` with scaled rows where the variant says so.
    ///
    /// The first four are graph Laplacians: they know how the mesh is joined, and lengths at most. The last two know its
    /// geometry. An edit minimises `‖K d‖²` of the displacement `d`. With the cotangent stiffness matrix alone that is
    /// `dᵀLLd`, in which small triangles count for less than their share of the surface; with the mass matrix `M` it is
    /// `dᵀLM⁻¹Ld`, the discrete `∫‖Δd‖²`, which is the same however densely the surface is sampled.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum Operator {
        /// The combinatorial graph Laplacian `L_s = D − Adj`, the paper's default (eq. 4): every edge weighs 1. Knows only the
        /// topology.
        #[default]
        UniformSymmetric = "L_s",
        /// The random-walk graph Laplacian `L = I − D⁻¹·Adj` (eq. 3): each row of `L_s` over its degree; not symmetric. Knows
        /// only the topology.
        Uniform = "L",
        /// Edge `ij` weighs `(dᵢ + dⱼ) / 2d̄` for degrees `d` with mean `d̄`: well-connected vertices pull more. Knows only the
        /// topology.
        Degree = "degree",
        /// Edge `ij` weighs `ℓ̄ / ℓᵢⱼ` for lengths `ℓ` at the start of the edit, with mean `ℓ̄`: close neighbours pull more.
        /// Clamped to `1/20 … 20`.
        InverseLength = "inverse-length",
        /// Edge `ij` weighs `½(cot α + cot β)` for the angles that face it (Pinkall and Polthier 1993). On a plane every
        /// linear function has `δ = 0` inside the rim, however the plane is cut into triangles. Triangles lower than 1/50 of
        /// their longest side fade into uniform weights, so that no cotangent exceeds 50 and no piece comes loose.
        Cotangent = "cotangent",
        /// The rows of [`Operator::Cotangent`] over `√mᵢ`, so that `KᵀK = L M⁻¹ L`; not symmetric. `mᵢ` is a third of the area
        /// of the triangles around vertex `i` (the lumped, barycentric mass), over the mean of all; at least 1/100.
        CotangentMass = "cotangent-mass",
    }
}

impl Operator {
    /// The matrix `K` over a mesh at rest; `positions` in any unit.
    ///
    /// # Errors
    /// [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for positions that do not fit.
    pub fn matrix(self, topology: &Topology, positions: &[DVec3]) -> Result<CsrMatrix<f64>, LaplacianError> {
        check_positions(topology, positions)?;
        let symmetric = difference_from_neighbours(topology, &self.edge_weights(topology, positions));
        Ok(match self {
            Self::Uniform => over_rows(symmetric, &weights::degrees(topology)),
            Self::CotangentMass => over_rows(symmetric, &weights::root_masses(topology, positions)),
            _ => symmetric,
        })
    }

    /// The operator with the same edge weights whose rows are not scaled, and which is symmetric.
    pub(crate) fn symmetric(self) -> Self {
        match self {
            Self::Uniform => Self::UniformSymmetric,
            Self::CotangentMass => Self::Cotangent,
            symmetric => symmetric,
        }
    }

    /// `W`: one weight for each of [`Topology::edges`].
    fn edge_weights(self, topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
        match self {
            Self::UniformSymmetric | Self::Uniform => weights::uniform(topology),
            Self::Degree => weights::by_degree(topology),
            Self::InverseLength => weights::by_inverse_length(topology, positions),
            Self::Cotangent | Self::CotangentMass => weights::cotangent(topology, positions),
        }
    }

    /// `W` by triangles: for each, its share in the weight of the side opposite each corner. The shares of a triangle are
    /// such that `Σ shareₖ ‖sideₖ‖²` is not negative, whatever is put for its sides.
    pub(crate) fn triangle_shares(self, topology: &Topology, positions: &[DVec3]) -> Vec<[f64; 3]> {
        match self {
            Self::Cotangent | Self::CotangentMass => weights::cotangent_shares(topology, positions),
            _ => weights::equal_shares(topology, &self.edge_weights(topology, positions)),
        }
    }
}

/// `diag(W·1) − W`, where `weights` has one entry for each of [`Topology::edges`].
fn difference_from_neighbours(topology: &Topology, weights: &[f64]) -> CsrMatrix<f64> {
    let n = topology.vertex_count();
    let mut entries = CooMatrix::new(n, n);
    // A vertex on its own keeps an explicit zero, so that every row has its diagonal.
    for vertex in 0..n {
        entries.push(vertex, vertex, 0.0);
    }
    for (&[a, b], &weight) in topology.edges().iter().zip(weights) {
        let [a, b] = [a as usize, b as usize];
        entries.push(a, b, -weight);
        entries.push(b, a, -weight);
        entries.push(a, a, weight);
        entries.push(b, b, weight);
    }
    CsrMatrix::from(&entries)
}

/// Each row over its divisor.
fn over_rows(mut matrix: CsrMatrix<f64>, divisors: &[f64]) -> CsrMatrix<f64> {
    for (mut row, divisor) in matrix.row_iter_mut().zip(divisors) {
        row.values_mut().iter_mut().for_each(|value| *value /= divisor);
    }
    matrix
}
