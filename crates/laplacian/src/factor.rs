use std::collections::BTreeMap;
use std::ops::Range;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Par, Side};
use nalgebra_sparse::CsrMatrix;

use crate::LaplacianError;
use crate::kernels::{add_scaled, dot};

/// Sparse Cholesky factorisation `P A Pᵀ = L Lᵀ` of a symmetric positive definite matrix, with a fill-reducing
/// permutation `P`.
///
/// `L` is stored by supernodes: ranges of columns with one sparsity pattern, each a dense panel. faer computes the
/// factor. The solves are implemented here, because a unit right-hand side touches only the path from its supernode to
/// the root of the elimination tree, which makes the forward substitution cheap.
pub struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    /// For each vertex, its row in `L`; `vertex_of` is the inverse.
    row_of: Vec<usize>,
    vertex_of: Vec<usize>,
    /// The supernode of each row of `L`.
    supernode_of: Vec<usize>,
}

/// Scratch buffers for a solve.
#[derive(Default)]
pub(crate) struct Scratch {
    rows: Vec<f64>,
    gathered: Vec<f64>,
}

/// `L⁻¹ P e_v` for a vertex `v`: the values along the path from the supernode of `v` to the root, concatenated.
///
/// Two paths that meet share their remainder, so two columns overlap in a common tail only.
#[derive(Default)]
pub(crate) struct HalfSolved {
    path: Vec<usize>,
    values: Vec<f64>,
}

/// Columns `start..start + width` of `L` in column-major order: the rows of the diagonal block, then those of
/// `pattern`.
struct Panel<'a> {
    start: usize,
    width: usize,
    pattern: &'a [usize],
    values: &'a [f64],
}

impl Factor {
    /// Orders by approximate minimum degree and factors. `matrix` must store both triangles.
    ///
    /// # Errors
    /// [`LaplacianError::BadlyScaled`] if a pivot is not positive.
    ///
    /// # Panics
    /// If the matrix is not square.
    pub fn new(matrix: &CsrMatrix<f64>) -> Result<Self, LaplacianError> {
        let symbolic = order(matrix);
        let values = factorize(matrix, &symbolic)?;
        let (vertex_of, row_of) = symbolic.perm().expect("invariant: an ordering was requested").arrays();
        let (vertex_of, row_of) = (vertex_of.to_vec(), row_of.to_vec());
        let supernodes = supernodes(&symbolic);
        let widths =
            supernodes.supernode_begin().iter().zip(supernodes.supernode_end()).map(|(begin, end)| end - begin);
        let supernode_of = widths.enumerate().flat_map(|(s, width)| std::iter::repeat_n(s, width)).collect();
        Ok(Self { values, row_of, vertex_of, supernode_of, symbolic })
    }

    /// `L⁻¹ P e_v` for each of `vertices`. Reads a panel once for all paths that contain it.
    pub(crate) fn half_solve(&self, vertices: &[u32]) -> Vec<HalfSolved> {
        let n = self.row_of.len();
        let mut work = vec![0.0; n * vertices.len()];
        let mut halves: Vec<HalfSolved> = vertices.iter().map(|_| HalfSolved::default()).collect();
        let mut waiting: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, &vertex) in vertices.iter().enumerate() {
            let row = self.row_of[vertex as usize];
            work[k * n + row] = 1.0;
            waiting.entry(self.supernode_of[row]).or_default().push(k);
        }
        // Paths only ascend, so no pending path can change the lowest supernode.
        while let Some((s, columns)) = waiting.pop_first() {
            let panel = self.panel(s);
            for &k in &columns {
                let column = &mut work[k * n..(k + 1) * n];
                panel.eliminate(column);
                halves[k].path.push(s);
                halves[k].values.extend_from_slice(&column[panel.start..panel.start + panel.width]);
            }
            if let Some(&row) = panel.pattern.first() {
                waiting.entry(self.supernode_of[row]).or_default().extend(columns);
            }
        }
        halves
    }

    /// `e_vᵀ A⁻¹ e_w` from the half-solved unit vectors of `v` and `w`.
    pub(crate) fn inverse_entry(&self, v: &HalfSolved, w: &HalfSolved) -> f64 {
        let from_root = v.path.iter().rev().zip(w.path.iter().rev());
        let common: usize = from_root.take_while(|(s, t)| s == t).map(|(&s, _)| self.panel(s).width).sum();
        dot(&v.values[v.values.len() - common..], &w.values[w.values.len() - common..])
    }

    /// Writes `L⁻¹ P b` to `rows` for a dense right-hand side `b`.
    pub(crate) fn forward(&self, b: &[f64], rows: &mut Vec<f64>) {
        rows.clear();
        rows.extend(self.vertex_of.iter().map(|&vertex| b[vertex]));
        (0..self.supernode_count()).for_each(|s| self.panel(s).eliminate(rows));
    }

    /// `e_vᵀ A⁻¹ b` from the half-solved `e_v` and `b`.
    pub(crate) fn inverse_row(&self, v: &HalfSolved, b: &[f64]) -> f64 {
        self.path_values(v).map(|(rows, values)| dot(values, &b[rows])).sum()
    }

    /// Adds `scale` times a half-solved unit vector to a half-solved right-hand side.
    pub(crate) fn add(&self, half: &HalfSolved, scale: f64, rows: &mut [f64]) {
        self.path_values(half).for_each(|(range, values)| add_scaled(&mut rows[range], scale, values));
    }

    /// Writes `Pᵀ L⁻ᵀ rows` to `out`, the second half of a solve. Overwrites `rows` and `gathered`.
    pub(crate) fn backward(&self, rows: &mut [f64], gathered: &mut Vec<f64>, out: &mut [f64]) {
        (0..self.supernode_count()).rev().for_each(|s| self.panel(s).substitute(rows, gathered));
        for (value, &row) in out.iter_mut().zip(&self.row_of) {
            *value = rows[row];
        }
    }

    /// Solves `A x = b` in place.
    ///
    /// # Panics
    /// If the length of `b` is not the number of rows.
    pub fn solve(&self, b: &mut [f64]) {
        self.solve_in(b, &mut Scratch::default());
    }

    /// [`Self::solve`] with scratch buffers; allocates only on their first use.
    pub(crate) fn solve_in(&self, b: &mut [f64], Scratch { rows, gathered }: &mut Scratch) {
        assert_eq!(b.len(), self.row_of.len(), "one value for each row");
        self.forward(b, rows);
        self.backward(rows, gathered, b);
    }

    /// The row ranges on the path of a half-solved unit vector, each with its values.
    fn path_values<'a>(&'a self, half: &'a HalfSolved) -> impl Iterator<Item = (Range<usize>, &'a [f64])> {
        let mut values = half.values.as_slice();
        half.path.iter().map(move |&s| {
            let panel = self.panel(s);
            let (own, rest) = values.split_at(panel.width);
            values = rest;
            (panel.start..panel.start + panel.width, own)
        })
    }

    fn supernode_count(&self) -> usize {
        supernodes(&self.symbolic).n_supernodes()
    }

    fn panel(&self, s: usize) -> Panel<'_> {
        let all = supernodes(&self.symbolic);
        let begin = all.supernode_begin()[s];
        Panel {
            start: begin,
            width: all.supernode_end()[s] - begin,
            pattern: all.supernode(s).pattern(),
            values: &self.values[all.col_ptr_for_val()[s]..all.col_ptr_for_val()[s + 1]],
        }
    }
}

impl Panel<'_> {
    /// One step of the forward substitution `x ← L⁻¹ x`.
    fn eliminate(&self, x: &mut [f64]) {
        let height = self.width + self.pattern.len();
        for (j, column) in self.values.chunks_exact(height).enumerate() {
            let row = self.start + j;
            x[row] /= column[j];
            let value = x[row];
            add_scaled(&mut x[row + 1..self.start + self.width], -value, &column[j + 1..self.width]);
            for (&row, &entry) in self.pattern.iter().zip(&column[self.width..]) {
                x[row] -= entry * value;
            }
        }
    }

    /// One step of the backward substitution `x ← L⁻ᵀ x`; overwrites `gathered`.
    fn substitute(&self, x: &mut [f64], gathered: &mut Vec<f64>) {
        let height = self.width + self.pattern.len();
        gathered.clear();
        gathered.extend(self.pattern.iter().map(|&row| x[row]));
        for (j, column) in self.values.chunks_exact(height).enumerate().rev() {
            let row = self.start + j;
            let below = dot(&column[j + 1..self.width], &x[row + 1..self.start + self.width]);
            x[row] = (x[row] - below - dot(&column[self.width..], gathered)) / column[j];
        }
    }
}

/// The symbolic factorisation of the sparsity pattern, supernodal for any matrix.
fn order(matrix: &CsrMatrix<f64>) -> SymbolicCholesky<usize> {
    let params = CholeskySymbolicParams {
        // A negative threshold selects supernodes even for a diagonal matrix, whose factorisation costs no flops.
        supernodal_flop_ratio_threshold: SupernodalThreshold(-1.0),
        ..Default::default()
    };
    factorize_symbolic_cholesky(pattern(matrix), Side::Lower, SymmetricOrdering::Amd, params)
        .expect("invariant: the pattern fits in memory and its indices fit in usize")
}

fn factorize(matrix: &CsrMatrix<f64>, symbolic: &SymbolicCholesky<usize>) -> Result<Vec<f64>, LaplacianError> {
    let mut values = vec![0.0; symbolic.len_val()];
    let scratch = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
    let mut memory = MemBuffer::new(scratch);
    let outcome = symbolic.factorize_numeric_llt(
        &mut values,
        SparseColMatRef::new(pattern(matrix), matrix.values()),
        Side::Lower,
        Default::default(),
        Par::Seq,
        MemStack::new(&mut memory),
        Default::default(),
    );
    match outcome {
        Ok(_) => Ok(values),
        Err(LltError::NonPositivePivot { index }) => {
            let order = symbolic.perm().expect("invariant: an ordering was requested");
            Err(LaplacianError::BadlyScaled { vertex: order.arrays().0[index] as u32 })
        }
    }
}

/// The pattern as faer's column-major type; the CSR storage of a symmetric matrix is also its CSC storage.
fn pattern(matrix: &CsrMatrix<f64>) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(
        matrix.nrows(),
        matrix.ncols(),
        matrix.row_offsets(),
        None,
        matrix.col_indices(),
    )
}

fn supernodes(symbolic: &SymbolicCholesky<usize>) -> &SymbolicSupernodalCholesky<usize> {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Supernodal(supernodes) => supernodes,
        SymbolicCholeskyRaw::Simplicial(_) => unreachable!("invariant: a supernodal factorisation was requested"),
    }
}
