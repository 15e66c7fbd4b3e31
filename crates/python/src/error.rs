use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

pyo3::create_exception!(
    rosto,
    RostoError,
    PyValueError,
    "Unreadable image, missing face or impossible edit. The message states what failed and what to do."
);

/// Converts an error of the core to a `RostoError`.
pub fn refused(reason: impl Display) -> PyErr {
    RostoError::new_err(reason.to_string())
}

/// Converts an error of a request, with its hint.
pub fn refused_request(reason: rosto::Error) -> PyErr {
    match reason.hint() {
        Some(hint) => refused(format!("{reason}. {hint}")),
        None => refused(reason),
    }
}

/// Runs the body of an entry point; `on` names its input. Turns a panic into a `RuntimeError`, which `except Exception`
/// catches, unlike pyo3's `PanicException`.
pub fn guarded<T>(on: &str, body: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    let outcome = catch_unwind(AssertUnwindSafe(body));
    outcome.unwrap_or_else(|_| Err(PyRuntimeError::new_err(format!("internal error on this {on}"))))
}
