//! Native part of the Python package `rosto`: the core over NumPy arrays.
//!
//! Long operations release the GIL. The crate starts no threads and has no global state; the package's Python code
//! (`rosto/`) caches the networks and converts arguments.

mod arrays;
mod edits;
mod error;
mod face_mesh;
mod finder;
mod options;
mod photo;
mod system;

use std::ffi::OsString;

use pyo3::prelude::*;
use rosto_photo::Limits;

use crate::error::guarded;

/// Native part of the package.
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

    /// Runs the command line with these arguments, the program's name first; returns the exit code.
    #[pyfunction]
    fn command_line(py: Python<'_>, words: Vec<OsString>) -> PyResult<u8> {
        guarded("command line", || Ok(py.detach(|| rosto_cli::command_line(words))))
    }

    /// Adds the maximum length of a photo's file in bytes.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("MAX_BYTES", Limits::default().max_bytes)
    }
}
