use std::iter::Sum;
use std::ops::Mul;

/// A sparse matrix stored by rows: the weights of the old vertices in each new vertex.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stencils {
    /// Number of old vertices.
    width: usize,
    starts: Vec<usize>,
    parents: Vec<u32>,
    weights: Vec<f64>,
}

impl Stencils {
    /// An empty matrix over `width` old vertices.
    pub(crate) fn new(width: usize) -> Self {
        Self { width, starts: vec![0], parents: Vec::new(), weights: Vec::new() }
    }

    pub(crate) fn identity(width: usize) -> Self {
        let mut identity = Self::new(width);
        (0..width as u32).for_each(|vertex| identity.push(vec![(vertex, 1.0)]));
        identity
    }

    /// Appends a row; entries with the same parent are summed.
    pub(crate) fn push(&mut self, mut entries: Vec<(u32, f64)>) {
        entries.sort_by_key(|&(parent, _)| parent);
        let first = self.parents.len();
        for (parent, weight) in entries {
            if self.parents[first..].last() == Some(&parent) {
                *self.weights.last_mut().expect("invariant: weights and parents have equal lengths") += weight;
            } else {
                self.parents.push(parent);
                self.weights.push(weight);
            }
        }
        self.starts.push(self.parents.len());
    }

    pub(crate) fn row(&self, row: usize) -> impl Iterator<Item = (u32, f64)> {
        let range = self.starts[row]..self.starts[row + 1];
        self.parents[range.clone()].iter().copied().zip(self.weights[range].iter().copied())
    }

    /// The matrix product `self · first`.
    pub(crate) fn after(&self, first: &Self) -> Self {
        let mut product = Self::new(first.width);
        for row in 0..self.starts.len() - 1 {
            let through = |(middle, outer): (u32, f64)| {
                first.row(middle as usize).map(move |(parent, inner)| (parent, outer * inner))
            };
            product.push(self.row(row).flat_map(through).collect());
        }
        product
    }

    /// The product of one row and `values`.
    pub(crate) fn combine<T: Copy + Mul<f64, Output = T> + Sum>(&self, row: usize, values: &[T]) -> T {
        assert_eq!(values.len(), self.width, "one value per cage vertex");
        self.row(row).map(|(parent, weight)| values[parent as usize] * weight).sum()
    }
}
