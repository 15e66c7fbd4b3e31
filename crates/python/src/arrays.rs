use glam::DVec3;
use numpy::ndarray::{Array2, ArrayView2};
use numpy::{Element, IntoPyArray, PyArray2};
use pyo3::prelude::*;

use crate::error::RostoError;

/// Rows of three or two as an array of the shape `(N, 3)` or `(N, 2)`.
pub fn from_rows<'py, T: Element, const N: usize>(
    py: Python<'py>,
    rows: Vec<[T; N]>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let shape = (rows.len(), N);
    let array = Array2::from_shape_vec(shape, rows.into_iter().flatten().collect());
    Ok(array.map_err(|reason| RostoError::new_err(reason.to_string()))?.into_pyarray(py))
}

/// An array of the shape `(N, 3)` as rows.
pub fn to_rows<T: Copy>(array: ArrayView2<'_, T>, what: &str) -> PyResult<Vec<[T; 3]>> {
    let row = |row: numpy::ndarray::ArrayView1<'_, T>| match row.as_slice() {
        Some(&[a, b, c]) => Some([a, b, c]),
        _ if row.len() == 3 => Some([row[0], row[1], row[2]]),
        _ => None,
    };
    let rows: Option<Vec<[T; 3]>> = array.rows().into_iter().map(row).collect();
    let (rows_found, columns) = array.dim();
    rows.ok_or_else(|| RostoError::new_err(format!("{what}: the shape is ({rows_found}, {columns}), not (N, 3)")))
}

/// The same, as positions or offsets.
pub fn to_vectors(array: ArrayView2<'_, f64>, what: &str) -> PyResult<Vec<DVec3>> {
    Ok(to_rows(array, what)?.into_iter().map(DVec3::from_array).collect())
}

/// Positions as an array of the shape `(N, 3)`.
pub fn from_vectors<'py>(py: Python<'py>, vectors: &[DVec3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    from_rows(py, vectors.iter().map(|vector| vector.to_array()).collect())
}
