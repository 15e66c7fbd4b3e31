use nalgebra::{DMatrix, DVector, Dyn, LU};

use crate::LaplacianError;

/// The small symmetric system that is left when all but the held vertices are eliminated; see
/// [`GroundedForm`](crate::grounded::GroundedForm).
pub(crate) struct Bordered<'a> {
    held: &'a [u32],
    /// The components that have a held vertex.
    touched: Vec<u32>,
    system: LU<f64, Dyn, Dyn>,
}

/// What the columns of `Φ`, and the constants on the components, are multiplied by.
pub(crate) struct Coefficients {
    pub(crate) columns: Vec<f64>,
    constants: Vec<(u32, f64)>,
}

impl<'a> Bordered<'a> {
    /// `entry(i, j)` is `Φ` between the `i`-th and `j`-th held vertex; it is asked for `i ≤ j` only.
    pub(crate) fn new(
        held: &'a [u32],
        component: &[u32],
        compliance: f64,
        entry: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let mut touched: Vec<u32> = held.iter().map(|&vertex| component[vertex as usize]).collect();
        touched.sort_unstable();
        touched.dedup();
        let k = held.len();
        let mut system = DMatrix::zeros(k + touched.len(), k + touched.len());
        for j in 0..k {
            for i in 0..=j {
                let value = entry(i, j);
                (system[(i, j)], system[(j, i)]) = (value, value);
            }
            system[(j, j)] += compliance;
            let own = k + touched.partition_point(|&other| other < component[held[j] as usize]);
            (system[(own, j)], system[(j, own)]) = (1.0, 1.0);
        }
        Self { held, touched, system: system.lu() }
    }

    /// The coefficients for target 1 at the `index`-th held vertex and 0 at the others.
    pub(crate) fn solve(&self, index: usize) -> Result<Coefficients, LaplacianError> {
        let k = self.held.len();
        let mut x = DVector::zeros(k + self.touched.len());
        x[index] = 1.0;
        if !self.system.solve_mut(&mut x) || x.iter().any(|value| !value.is_finite()) {
            return Err(LaplacianError::BadlyScaled { vertex: self.held[index] });
        }
        let (columns, constants) = x.as_slice().split_at(k);
        Ok(Coefficients {
            columns: columns.to_vec(),
            constants: self.touched.iter().copied().zip(constants.iter().copied()).collect(),
        })
    }
}

impl Coefficients {
    /// Adds `P t`.
    pub(crate) fn add_constants(&self, component: &[u32], field: &mut [f64]) {
        for &(touched, constant) in &self.constants {
            for (value, &component) in field.iter_mut().zip(component) {
                if component == touched {
                    *value += constant;
                }
            }
        }
    }
}
