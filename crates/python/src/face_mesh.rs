use std::sync::{Mutex, PoisonError};

use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::{from_rows, from_vectors};
use crate::error::{guarded, refused};
use crate::finder::Finder;
use crate::photo::Photo;

/// A face mesh, as `rosto mesh` computes it.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct FaceMesh(Mutex<rosto_cli::FaceMesh>);

#[pymethods]
impl FaceMesh {
    /// Takes one or more photos of one face, and command-line arguments.
    #[new]
    fn new(py: Python<'_>, photos: Vec<PyRef<'_, Photo>>, finder: &Finder, options: Vec<String>) -> PyResult<Self> {
        guarded("photo", || {
            let photos = photos.iter().map(|photo| photo.0.clone()).collect();
            let made = py.detach(|| rosto_cli::FaceMesh::new(photos, &finder.0, &options));
            made.map(|face| Self(Mutex::new(face))).map_err(refused)
        })
    }

    /// Positions in metres in the model's frame, shape `(V, 3)`.
    fn positions_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        guarded("photo", || from_vectors(py, self.locked().positions_m()))
    }

    /// Triangles, counter-clockwise as seen from outside, shape `(T, 3)`.
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        guarded("photo", || from_rows(py, self.locked().triangles().to_vec()))
    }

    /// Vertex colours in sRGB, shape `(V, 3)`.
    fn colours<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u8>>> {
        guarded("photo", || from_rows(py, self.locked().colours_srgb()))
    }

    /// Coordinates in the photo, 0 to 1 from its top left corner, shape `(V, 2)`.
    fn uvs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        guarded("photo", || from_rows(py, self.locked().uvs().iter().map(|uv| uv.to_array()).collect()))
    }

    /// Returns names and bytes of the file `name` and of its companion files.
    fn write<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        options: Vec<String>,
    ) -> PyResult<Vec<(String, Bound<'py, PyBytes>)>> {
        guarded("photo", || {
            let written = py.detach(|| self.locked().write(name, &options)).map_err(refused)?;
            let sidecars = written.sidecars.into_iter().map(|file| (file.name, file.bytes));
            let files = [(name.to_owned(), written.bytes)].into_iter().chain(sidecars);
            Ok(files.map(|(name, bytes)| (name, PyBytes::new(py, &bytes))).collect())
        })
    }
}

impl FaceMesh {
    fn locked(&self) -> std::sync::MutexGuard<'_, rosto_cli::FaceMesh> {
        // Writing does not change the face, even if it fails.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
