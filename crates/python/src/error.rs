use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

pyo3::create_exception!(
    rosto,
    RostoError,
    PyValueError,
    "An image that cannot be read, a face that is not there, an edit that cannot be made: says what failed and what to do."
);

/// Any of the core's errors as Python's.
pub fn refused(reason: impl Display) -> PyErr {
    RostoError::new_err(reason.to_string())
}

/// Runs the body of an entry point. A panic becomes a `RuntimeError`, which `except Exception` catches; pyo3's own
/// exception for panics passes it by. `on` is what was being worked on.
pub fn guarded<T>(on: &str, body: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    let outcome = catch_unwind(AssertUnwindSafe(body));
    outcome.unwrap_or_else(|_| Err(PyRuntimeError::new_err(format!("internal error on this {on}"))))
}
