use glam::DVec3;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use rosto_laplacian::{ConstraintKind, Constraints, LaplacianSystem, Operator};
use rosto_mesh::Topology;

use crate::arrays::{from_vectors, to_rows, to_vectors};
use crate::error::{guarded, refused};

/// A mesh with a factorised Laplacian.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct System {
    rest: Vec<DVec3>,
    system: LaplacianSystem,
}

/// Sparse matrix in CSR format: values, column indices, row pointers.
type Csr<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>);

#[pymethods]
impl System {
    #[new]
    fn new(
        py: Python<'_>,
        positions: PyReadonlyArray2<'_, f64>,
        triangles: PyReadonlyArray2<'_, u32>,
        operator: &str,
    ) -> PyResult<Self> {
        guarded("mesh", || {
            let ids = Operator::ALL.map(Operator::id).join(", ");
            let operator = Operator::from_id(operator)
                .ok_or_else(|| refused(format!("unknown operator {operator:?}; use one of {ids}")))?;
            let rest = to_vectors(&positions, "positions")?;
            let topology = Topology::new(rest.len(), to_rows(&triangles, "triangles")?).map_err(refused)?;
            let system = py.detach(|| LaplacianSystem::new(&topology, &rest, operator)).map_err(refused)?;
            Ok(Self { rest, system })
        })
    }

    /// Positions after moving `handles` by `offsets`. Constraints are soft with `weight`, hard without.
    #[pyo3(signature = (handles, offsets, anchors, weight=None))]
    fn edit<'py>(
        &self,
        py: Python<'py>,
        handles: Vec<u32>,
        offsets: PyReadonlyArray2<'_, f64>,
        anchors: Vec<u32>,
        weight: Option<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        guarded("mesh", || {
            let offsets = to_vectors(&offsets, "offsets")?;
            if offsets.len() != handles.len() {
                return Err(refused(format!("{} offsets for {} handles", offsets.len(), handles.len())));
            }
            let kind = weight.map_or(ConstraintKind::Hard, |weight| ConstraintKind::Soft { weight });
            let constraints = Constraints { handles: &handles, anchors: &anchors, kind, falloff: None };
            let mut edited = self.rest.clone();
            let response = py.detach(|| self.system.respond(&constraints)).map_err(refused)?;
            response.displace(&self.rest, &offsets, &mut edited);
            from_vectors(py, &edited)
        })
    }

    /// δ-coordinates of any positions of the mesh's vertices.
    fn deltas<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        guarded("mesh", || {
            let positions = to_vectors(&positions, "positions")?;
            if positions.len() != self.rest.len() {
                return Err(refused(format!("{} positions for {} vertices", positions.len(), self.rest.len())));
            }
            from_vectors(py, &self.system.deltas(&positions))
        })
    }

    /// Matrix of the operator.
    fn matrix<'py>(&self, py: Python<'py>) -> PyResult<Csr<'py>> {
        guarded("mesh", || {
            let (starts, columns, values) = self.system.operator().csr_data();
            let whole = |numbers: &[usize]| numbers.iter().map(|&number| number as i64).collect::<Vec<_>>();
            Ok((values.to_vec().into_pyarray(py), whole(columns).into_pyarray(py), whole(starts).into_pyarray(py)))
        })
    }
}
