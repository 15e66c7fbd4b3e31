use numpy::PyArray2;
use pyo3::prelude::*;
use rosto_landmarks::{FaceFinder, FindOptions, LandmarkNetwork};

use crate::arrays::from_rows;
use crate::error::{guarded, refused};
use crate::photo::Photo;

/// The face networks, loaded once.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct Finder(pub(crate) FaceFinder);

/// Landmarks of shape `(468, 3)` or `(478, 3)`, score, presence, confidence.
type Found<'py> = (Bound<'py, PyArray2<f32>>, f32, f32, f32);

#[pymethods]
impl Finder {
    #[new]
    fn new(py: Python<'_>, detector_onnx: &[u8], landmarks_onnx: &[u8], refined: bool) -> PyResult<Self> {
        guarded("network", || {
            let network = if refined { LandmarkNetwork::Attention } else { LandmarkNetwork::Plain };
            py.detach(|| FaceFinder::new(detector_onnx, network(landmarks_onnx))).map(Self).map_err(refused)
        })
    }

    /// Returns the faces in a photo, most prominent first, up to `max_faces` or the search's default.
    #[pyo3(signature = (photo, thorough, max_faces=None))]
    fn find<'py>(
        &self,
        py: Python<'py>,
        photo: &Photo,
        thorough: bool,
        max_faces: Option<usize>,
    ) -> PyResult<Vec<Found<'py>>> {
        guarded("photo", || {
            let options = options_of(thorough, max_faces);
            let faces = py.detach(|| self.0.find(&photo.0, &options)).map_err(refused)?;
            let found = faces
                .into_iter()
                .map(|face| Ok((from_rows(py, face.landmarks)?, face.score, face.presence, face.confidence)));
            found.collect()
        })
    }
}

/// Options of a search for up to `max_faces` faces, or its default.
pub fn options_of(thorough: bool, max_faces: Option<usize>) -> FindOptions {
    let usual = if thorough { FindOptions::default() } else { FindOptions::mediapipe() };
    FindOptions { max_faces: max_faces.unwrap_or(usual.max_faces), ..usual }
}
