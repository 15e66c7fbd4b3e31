use numpy::ndarray::ArrayView3;
use numpy::{IntoPyArray, PyArray3, PyReadonlyArray3};
use pyo3::prelude::*;
use rosto_photo::Limits;

use crate::error::refused;

/// An upright sRGB picture.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct Photo(pub(crate) rosto_photo::Photo);

#[pymethods]
impl Photo {
    /// Decodes a JPEG, PNG or WebP file.
    #[staticmethod]
    fn decode(py: Python<'_>, file: &[u8]) -> PyResult<Self> {
        let decoded = py.detach(|| rosto_photo::decode(file, &Limits::default()));
        decoded.map(Self).map_err(|reason| refused(format!("{reason}. {}", reason.hint())))
    }

    /// A copy of pixels of the shape `(height, width, 3)`, red, green and blue.
    #[staticmethod]
    fn from_array(pixels: PyReadonlyArray3<'_, u8>) -> PyResult<Self> {
        let (height, width, _) = pixels.as_array().dim();
        let bytes = pixels.as_array().iter().copied().collect();
        rosto_photo::Photo::from_rgb(width as u32, height as u32, bytes).map(Self).map_err(refused)
    }

    /// Its pixels, of the shape `(height, width, 3)`.
    fn pixels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let (height, width) = self.size();
        let view = ArrayView3::from_shape((height as usize, width as usize, 3), self.0.pixels()).map_err(refused)?;
        Ok(view.to_owned().into_pyarray(py))
    }

    /// Height and width in px.
    #[getter]
    fn size(&self) -> (u32, u32) {
        (self.0.height(), self.0.width())
    }
}
