use glam::DVec3;
use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::{LaplacianError, check_positions, weights};

/// A discrete Laplace–Beltrami operator `K`, which turns positions into δ-coordinates: `δ = K x`.
///
/// Every operator is `n × n`, dimensionless (no matter the unit of the positions), positive on the diagonal, has rows that
/// sum to 0, and so takes no notice of translations; `δᵢ` points from a weighted mean of the neighbours to vertex `i`.
/// All but [`Operator::Uniform`] are symmetric, positive semi-definite `K = diag(W·1) − W` for edge weights `W`, with one
/// zero eigenvalue for each component of the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Operator {
    /// `L_s = D − Adj`, the paper's default (eq. 4): every edge weighs 1. Knows only the topology.
    #[default]
    UniformSymmetric,
    /// `L = I − D⁻¹·Adj` (eq. 3): each row of `L_s` over its degree; not symmetric. Knows only the topology.
    Uniform,
    /// Edge `ij` weighs `(dᵢ + dⱼ) / 2d̄` for degrees `d` with mean `d̄`: well-connected vertices pull more. Knows only the
    /// topology.
    Degree,
    /// Edge `ij` weighs `ℓ̄ / ℓᵢⱼ` for lengths `ℓ` at the start of the edit, with mean `ℓ̄`: close neighbours pull more.
    /// Clamped to `1/20 … 20`.
    InverseLength,
    /// Edge `ij` weighs `½(cot α + cot β)` for the angles that face it (Pinkall and Polthier 1993). On a plane every
    /// linear function has `δ = 0` inside the rim, however the plane is cut into triangles. Triangles lower than 1/50 of
    /// their longest side fade into uniform weights, so that no cotangent exceeds 50 and no piece comes loose.
    Cotangent,
}

impl Operator {
    /// All of them, in the order of their definition.
    pub const ALL: [Self; 5] =
        [Self::UniformSymmetric, Self::Uniform, Self::Degree, Self::InverseLength, Self::Cotangent];

    /// The matrix `K` over a mesh at rest; `positions` in any unit.
    ///
    /// # Errors
    /// [`LaplacianError::LengthMismatch`] or [`LaplacianError::NotFinite`] for positions that do not fit.
    pub fn matrix(self, topology: &Topology, positions: &[DVec3]) -> Result<CsrMatrix<f64>, LaplacianError> {
        check_positions(topology, positions)?;
        let symmetric = difference_from_neighbours(topology, &self.edge_weights(topology, positions));
        Ok(if self == Self::Uniform { over_degree(symmetric) } else { symmetric })
    }

    /// `W`: one weight for each of [`Topology::edges`].
    fn edge_weights(self, topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
        match self {
            Self::UniformSymmetric | Self::Uniform => weights::uniform(topology),
            Self::Degree => weights::by_degree(topology),
            Self::InverseLength => weights::by_inverse_length(topology, positions),
            Self::Cotangent => weights::cotangent(topology, positions),
        }
    }

    /// `W` by triangles: for each, its share in the weight of the side opposite each corner. The shares of a triangle are
    /// such that `Σ shareₖ ‖sideₖ‖²` is not negative, whatever is put for its sides.
    pub(crate) fn triangle_shares(self, topology: &Topology, positions: &[DVec3]) -> Vec<[f64; 3]> {
        match self {
            Self::Cotangent => weights::cotangent_shares(topology, positions),
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

fn over_degree(mut matrix: CsrMatrix<f64>) -> CsrMatrix<f64> {
    for mut row in matrix.row_iter_mut() {
        let degree = row.nnz().saturating_sub(1).max(1) as f64;
        row.values_mut().iter_mut().for_each(|value| *value /= degree);
    }
    matrix
}
