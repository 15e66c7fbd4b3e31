use glam::DVec3;
use numpy::ndarray::{Array2, Dimension};
use numpy::{Element, IntoPyArray, PyArray2, PyReadonlyArray, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::error::refused;

/// Converts rows to an array of shape `(rows, N)`.
pub fn from_rows<'py, T: Element, const N: usize>(
    py: Python<'py>,
    rows: Vec<[T; N]>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let shape = (rows.len(), N);
    let array = Array2::from_shape_vec(shape, rows.into_iter().flatten().collect());
    Ok(array.map_err(refused)?.into_pyarray(py))
}

/// Converts a C-contiguous, aligned array of shape `(N, 3)` to rows; `what` names it in errors.
pub fn to_rows<T: Element + Copy>(array: &PyReadonlyArray2<'_, T>, what: &str) -> PyResult<Vec<[T; 3]>> {
    let &[rows, columns] = array.shape() else { return Err(refused(format!("{what}: not two axes"))) };
    if columns != 3 {
        return Err(refused(format!("{what}: the shape is ({rows}, {columns}), not (N, 3)")));
    }
    Ok(c_ordered(array, what)?.as_chunks::<3>().0.to_vec())
}

/// Elements of a C-contiguous, aligned array. Refuses Fortran-contiguous arrays, which have another order.
pub fn c_ordered<'a, T: Element, D: Dimension>(array: &'a PyReadonlyArray<'_, T, D>, what: &str) -> PyResult<&'a [T]> {
    let elements = array.as_slice().ok().filter(|_| array.is_c_contiguous());
    elements.ok_or_else(|| refused(format!("{what}: the array is not C-contiguous and aligned")))
}

/// Converts an array of shape `(N, 3)` to finite vectors.
pub fn to_vectors(array: &PyReadonlyArray2<'_, f64>, what: &str) -> PyResult<Vec<DVec3>> {
    let vectors: Vec<DVec3> = to_rows(array, what)?.into_iter().map(DVec3::from_array).collect();
    match vectors.iter().position(|vector| !vector.is_finite()) {
        Some(row) => Err(refused(format!("{what}: row {row} is not finite"))),
        None => Ok(vectors),
    }
}

/// Converts finite vectors to an array of shape `(N, 3)`.
pub fn from_vectors<'py>(py: Python<'py>, vectors: &[DVec3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    if !vectors.iter().all(|vector| vector.is_finite()) {
        return Err(refused("the result is not finite: use smaller coordinates or offsets"));
    }
    from_rows(py, vectors.iter().map(|vector| vector.to_array()).collect())
}
