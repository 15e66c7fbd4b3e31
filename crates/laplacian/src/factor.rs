use std::collections::BTreeMap;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::{SupernodalLltRef, SupernodeRef};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{ColMut, Conj, MatMut, Par, Side};
use nalgebra::{DMatrix, DVectorView};
use nalgebra_sparse::CsrMatrix;

use crate::LaplacianError;

/// Sparse Cholesky factorisation `P A Pᵀ = L Lᵀ` of a symmetric positive definite matrix, with a fill-reducing
/// permutation `P`. Computed by faer on one thread.
pub struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
}

/// Scratch buffer for the solves of one factor, of up to a number of columns at once.
pub(crate) struct Scratch(MemBuffer);

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
        Ok(Self { values: factorize(matrix, &symbolic)?, symbolic })
    }

    /// Solves `A x = b` in place.
    ///
    /// # Panics
    /// If the length of `b` is not the number of rows.
    pub fn solve(&self, b: &mut [f64]) {
        assert_eq!(b.len(), self.symbolic.nrows(), "one value for each row");
        self.solve_in(b, &mut self.scratch(1));
    }

    /// [`Self::solve`] for columns one after the other, without an allocation, in a buffer from [`Self::scratch`]. Reads
    /// the factor once for all columns.
    pub(crate) fn solve_in(&self, b: &mut [f64], Scratch(memory): &mut Scratch) {
        let rows = self.symbolic.nrows();
        let columns = b.len() / rows;
        let b = MatMut::from_column_major_slice_mut(b, rows, columns);
        let factor = LltRef::new(&self.symbolic, &self.values);
        factor.solve_in_place_with_conj(Conj::No, b, Par::Seq, MemStack::new(memory));
    }

    pub(crate) fn scratch(&self, columns: usize) -> Scratch {
        Scratch(MemBuffer::new(self.symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq)))
    }

    /// Returns the entries of `A⁻¹` between these vertices: `⟨L⁻¹ P e_v, L⁻¹ P e_w⟩`.
    ///
    /// `L⁻¹ P e_v` is non-zero only on the path from the supernode of `v` to the root of the elimination tree, which
    /// makes it several times cheaper than a solve. Reads a supernode once for all paths that contain it.
    pub(crate) fn inverse_among(&self, vertices: &[u32]) -> DMatrix<f64> {
        let (factor, (_, row_of)) = (self.supernodes(), permutation(&self.symbolic));
        let rows = row_of.len();
        let mut entries = DMatrix::zeros(vertices.len(), vertices.len());
        let mut half_solved = vec![0.0; rows * vertices.len()];
        let mut waiting: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, &vertex) in vertices.iter().enumerate() {
            let row = row_of[vertex as usize];
            half_solved[k * rows + row] = 1.0;
            waiting.entry(supernode_of(factor, row)).or_default().push(k);
        }
        // Paths only ascend, so no pending path can change the lowest supernode.
        while let Some((s, on_path)) = waiting.pop_first() {
            let supernode = factor.supernode(s);
            eliminate(supernode, &on_path, rows, &mut half_solved);
            let own = |k: usize| {
                let values = &half_solved[k * rows + supernode.start()..][..supernode.val().ncols()];
                DVectorView::from_slice(values, values.len())
            };
            for (at, &i) in on_path.iter().enumerate() {
                on_path[..=at].iter().for_each(|&j| entries[(i.max(j), i.min(j))] += own(i).dot(&own(j)));
            }
            if let Some(&row) = supernode.pattern().iter().min() {
                waiting.entry(supernode_of(factor, row)).or_default().extend(on_path);
            }
        }
        entries.fill_upper_triangle_with_lower_triangle();
        entries
    }

    fn supernodes(&self) -> SupernodalLltRef<'_, usize, f64> {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Supernodal(symbolic) => SupernodalLltRef::new(symbolic, &self.values),
            SymbolicCholeskyRaw::Simplicial(_) => unreachable!("invariant: a supernodal factorisation was requested"),
        }
    }
}

/// The supernode that contains a row of `L`.
fn supernode_of(factor: SupernodalLltRef<'_, usize, f64>, row: usize) -> usize {
    factor.symbolic().supernode_end().partition_point(|&end| end <= row)
}

/// The part of the forward substitution `x ← L⁻¹ x` that belongs to the columns of one supernode, for the vectors
/// `on_path` among the concatenated `xs`.
fn eliminate(supernode: SupernodeRef<'_, usize, f64>, on_path: &[usize], rows: usize, xs: &mut [f64]) {
    let (start, width) = (supernode.start(), supernode.val().ncols());
    let mut column = vec![0.0; supernode.val().nrows()];
    for j in 0..width {
        ColMut::from_slice_mut(&mut column).copy_from(supernode.val().col(j));
        let (own, below) = column.split_at(width);
        for &k in on_path {
            let x = &mut xs[k * rows..(k + 1) * rows];
            let value = x[start + j] / own[j];
            x[start + j] = value;
            x[start + j + 1..start + width].iter_mut().zip(&own[j + 1..]).for_each(|(x, entry)| *x -= entry * value);
            supernode.pattern().iter().zip(below).for_each(|(&row, entry)| x[row] -= entry * value);
        }
    }
}

/// The symbolic factorisation of the sparsity pattern, supernodal for any matrix.
fn order(matrix: &CsrMatrix<f64>) -> SymbolicCholesky<usize> {
    // A negative threshold selects supernodes even for a diagonal matrix, whose factorisation costs no flops.
    let supernodal_flop_ratio_threshold = SupernodalThreshold(-1.0);
    let params = CholeskySymbolicParams { supernodal_flop_ratio_threshold, ..Default::default() };
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
            Err(LaplacianError::BadlyScaled { vertex: permutation(symbolic).0[index] as u32 })
        }
    }
}

/// The vertex of each row of `L`, and the row of each vertex.
fn permutation(symbolic: &SymbolicCholesky<usize>) -> (&[usize], &[usize]) {
    symbolic.perm().expect("invariant: an ordering was requested").arrays()
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
