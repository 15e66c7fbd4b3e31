use numpy::ndarray::ArrayView3;
use numpy::{IntoPyArray, PyArray3, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use rosto_photo::{Limits, PhotoError};

use crate::arrays::c_ordered;
use crate::error::{guarded, refused};

/// An upright sRGB picture.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct Photo(pub(crate) rosto_photo::Photo);

#[pymethods]
impl Photo {
    /// Decodes a JPEG, PNG or WebP file without a length limit.
    #[staticmethod]
    fn decode(py: Python<'_>, file: &[u8]) -> PyResult<Self> {
        guarded("photo", || {
            let limits = Limits { max_bytes: usize::MAX, ..Limits::default() };
            py.detach(|| rosto_photo::decode(file, &limits)).map(Self).map_err(not_a_photo)
        })
    }

    /// Copies C-contiguous pixels of shape `(height, width)` or `(height, width, N)`: grey for N = 1, RGB for N = 3, RGBA
    /// for N = 4, composited over white.
    #[staticmethod]
    fn from_array(pixels: PyReadonlyArrayDyn<'_, u8>) -> PyResult<Self> {
        guarded("photo", || {
            let (height, width, channels) = match *pixels.shape() {
                [height, width] => (height, width, 1),
                [height, width, channels] => (height, width, channels),
                _ => return Err(refused(format!("pixels: {} axes, not 2 or 3", pixels.ndim()))),
            };
            let (width, height) = checked_size(width, height)?;
            let pixels = c_ordered(&pixels, "pixels")?;
            let photo = match channels {
                1 => rosto_photo::Photo::from_rgb(width, height, pixels.iter().flat_map(|&grey| [grey; 3]).collect()),
                3 => rosto_photo::Photo::from_rgb(width, height, pixels.to_vec()),
                4 => rosto_photo::Photo::from_rgba(width, height, pixels),
                _ => return Err(refused(format!("pixels: {channels} channels, not 1, 3 or 4"))),
            };
            photo.map(Self).map_err(not_a_photo)
        })
    }

    /// Pixels, shape `(height, width, 3)`.
    fn pixels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u8>>> {
        guarded("photo", || {
            let shape = (self.0.height() as usize, self.0.width() as usize, 3);
            let view = ArrayView3::from_shape(shape, self.0.pixels()).map_err(refused)?;
            Ok(view.to_owned().into_pyarray(py))
        })
    }

    /// Height and width in px.
    #[getter]
    fn size(&self) -> PyResult<(u32, u32)> {
        guarded("photo", || Ok((self.0.height(), self.0.width())))
    }
}

/// Raises if a file of `bytes` bytes exceeds the limit for photos.
#[pyfunction]
pub fn check_length(bytes: u64) -> PyResult<()> {
    guarded("photo", || Limits::default().check_length(bytes).map_err(not_a_photo))
}

/// Raises if a picture of this size has no pixels, or exceeds the limit for photos.
#[pyfunction]
pub fn check_size(height: usize, width: usize) -> PyResult<()> {
    guarded("photo", || checked_size(width, height).map(drop))
}

fn checked_size(width: usize, height: usize) -> PyResult<(u32, u32)> {
    let [short_width, short_height] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    if width == 0 || height == 0 {
        return Err(refused(format!("the picture is {width}×{height} px: it has no pixels")));
    }
    Limits::default().check_size(short_width, short_height).map_err(not_a_photo)?;
    Ok((short_width, short_height))
}

fn not_a_photo(reason: PhotoError) -> PyErr {
    refused(format!("{reason}. {}", reason.hint()))
}
