use std::fmt::Display;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    rosto,
    RostoError,
    PyValueError,
    "A photo that cannot be read, a face that is not there, an edit that cannot be made: says what, and what to do."
);

/// Any of the core's errors as Python's.
pub fn refused(reason: impl Display) -> PyErr {
    RostoError::new_err(reason.to_string())
}
