//! What the Python package `rosto` is made of: the same core as the command line's, over NumPy arrays.
//!
//! Whatever takes a while lets other threads of Python run. Nothing here has a thread of its own or global state; the
//! package's Python (`rosto/`) keeps the networks and turns people's arguments into these.

mod arrays;
mod error;
mod face_mesh;
mod finder;
mod photo;
mod system;

use std::ffi::OsString;

use pyo3::prelude::*;
use rosto_photo::Limits;

use crate::error::guarded;

/// The native part of the package.
#[pymodule(gil_used = false)]
mod _rosto {
    use super::*;

    #[pymodule_export]
    use super::error::RostoError;
    #[pymodule_export]
    use super::face_mesh::FaceMesh;
    #[pymodule_export]
    use super::finder::Finder;
    #[pymodule_export]
    use super::photo::{Photo, check_length, check_size};
    #[pymodule_export]
    use super::system::System;

    /// Does what the words of a command line ask for, the program's name first; returns its exit code.
    #[pyfunction]
    fn command_line(py: Python<'_>, words: Vec<OsString>) -> PyResult<u8> {
        guarded("command line", || Ok(py.detach(|| rosto_cli::command_line(words))))
    }

    /// The length in bytes that a photo's file may have at most.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("MAX_BYTES", Limits::default().max_bytes)
    }
}
