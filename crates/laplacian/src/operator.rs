use glam::DVec3;
use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::{LaplacianError, check_positions, weights};

rosto_mesh::named! {
    /// A discrete Laplacian `K`, which maps positions to δ-coordinates: `δ = K x`.
    ///
    /// Every operator is `n × n` and dimensionless, has a positive diagonal and rows that sum to 0, and is therefore
    /// invariant to translation. `δᵢ` points from a weighted mean of the neighbours to vertex `i`. The edge weights `W`
    /// give the symmetric positive semi-definite `L = diag(W·1) − W`, with one zero eigenvalue per connected component.
    /// `K` is `L`, or `L` with scaled rows where the variant says so.
    ///
    /// The first four are graph Laplacians, which use the connectivity and at most the edge lengths. The last two use
    /// the geometry. An edit minimises `‖K d‖²` over the displacement `d`. With the cotangent stiffness matrix that is
    /// `dᵀLLd`, which underweights small triangles. With the mass matrix `M` it is `dᵀLM⁻¹Ld`, the discrete `∫‖Δd‖²`,
    /// which is independent of the sampling density.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum Operator {
        /// The combinatorial graph Laplacian `L_s = D − Adj`, the paper's default (eq. 4). Every edge weight is 1.
        /// Depends only on the topology.
        #[default]
        UniformSymmetric = "L_s",
        /// The random-walk graph Laplacian `L = I − D⁻¹·Adj` (eq. 3): the rows of `L_s` divided by the degree; not
        /// symmetric. Depends only on the topology.
        Uniform = "L",
        /// Edge `ij` has weight `(dᵢ + dⱼ) / 2d̄`, with vertex degrees `d` and their mean `d̄`. Depends only on the
        /// topology.
        Degree = "degree",
        /// Edge `ij` has weight `ℓ̄ / ℓᵢⱼ`, clamped to `1/20 … 20`, with rest lengths `ℓ` and their mean `ℓ̄`.
        InverseLength = "inverse-length",
        /// Edge `ij` has weight `½(cot α + cot β)` for the opposite angles `α` and `β` (Pinkall and Polthier 1993). On
        /// a plane, a linear function has `δ = 0` away from the boundary for any triangulation. Triangles with a height
        /// below 1/50 of their longest side blend into uniform weights, which bounds cotangents by 50 and keeps
        /// components connected.
        Cotangent = "cotangent",
        /// The rows of [`Operator::Cotangent`] divided by `√mᵢ`, so that `KᵀK = L M⁻¹ L`; not symmetric. `mᵢ` is the
        /// lumped barycentric mass of vertex `i`, a third of the area of its triangles, divided by the mean mass; at
        /// least 1/100.
        CotangentMass = "cotangent-mass",
    }
}

impl Operator {
    /// Builds the matrix `K` from the rest positions, in any unit.
    ///
    /// # Errors
    /// [`LaplacianError::Empty`], [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for invalid
    /// positions.
    pub fn matrix(self, topology: &Topology, positions: &[DVec3]) -> Result<CsrMatrix<f64>, LaplacianError> {
        check_positions(topology, positions)?;
        let symmetric = laplacian_matrix(topology, &self.edge_weights(topology, positions));
        Ok(match self {
            Self::Uniform => divide_rows(symmetric, &weights::degrees(topology)),
            Self::CotangentMass => divide_rows(symmetric, &weights::root_masses(topology, positions)),
            _ => symmetric,
        })
    }

    /// The symmetric operator with the same edge weights and unscaled rows.
    pub(crate) fn symmetric(self) -> Self {
        match self {
            Self::Uniform => Self::UniformSymmetric,
            Self::CotangentMass => Self::Cotangent,
            symmetric => symmetric,
        }
    }

    /// The weights `W`, one per entry of [`Topology::edges`].
    fn edge_weights(self, topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
        match self {
            Self::UniformSymmetric | Self::Uniform => weights::uniform(topology),
            Self::Degree => weights::by_degree(topology),
            Self::InverseLength => weights::by_inverse_length(topology, positions),
            Self::Cotangent | Self::CotangentMass => weights::cotangent(topology, positions),
        }
    }

    /// The contribution of each triangle to `W`, per corner for the opposite side. `Σ shareₖ ‖sideₖ‖²` is non-negative
    /// for any side vectors.
    pub(crate) fn triangle_shares(self, topology: &Topology, positions: &[DVec3]) -> Vec<[f64; 3]> {
        match self {
            Self::Cotangent | Self::CotangentMass => weights::cotangent_shares(topology, positions),
            _ => weights::equal_shares(topology, &self.edge_weights(topology, positions)),
        }
    }
}

/// `diag(W·1) − W`, with one weight per entry of [`Topology::edges`].
pub(crate) fn laplacian_matrix(topology: &Topology, weights: &[f64]) -> CsrMatrix<f64> {
    let n = topology.vertex_count();
    let mut entries = CooMatrix::new(n, n);
    // Isolated vertices get an explicit zero, so that every row stores its diagonal.
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

/// Divides each row by its divisor.
fn divide_rows(mut matrix: CsrMatrix<f64>, divisors: &[f64]) -> CsrMatrix<f64> {
    for (mut row, divisor) in matrix.row_iter_mut().zip(divisors) {
        row.values_mut().iter_mut().for_each(|value| *value /= divisor);
    }
    matrix
}
