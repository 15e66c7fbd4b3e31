use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use rosto::FaceError;
use rosto::{Command, Format, MAX_PHOTOS, MeshRequest, Observation, PhotoLens};

use crate::arrays::{from_rows, from_vectors};
use crate::edits::Edit;
use crate::error::{guarded, refused, refused_request};
use crate::finder::{Finder, options_of};
use crate::options::{Named, Options, OptionsOfFile};
use crate::photo::Photo;

/// A face mesh, as `rosto mesh` computes it.
#[pyclass(frozen, module = "rosto._rosto")]
pub struct FaceMesh {
    mesh: Mutex<rosto::FaceMesh>,
    /// The request without its photos.
    request: MeshRequest,
    file: OptionsOfFile,
}

#[pymethods]
impl FaceMesh {
    /// Takes one or more photos of one face, edits in their order, and options.
    #[new]
    fn new(
        py: Python<'_>,
        photos: Vec<PyRef<'_, Photo>>,
        finder: &Finder,
        thorough: bool,
        edits: Vec<Edit>,
        options: Named<'_>,
    ) -> PyResult<Self> {
        guarded("photo", || {
            let Options { mut request, settings, lens, card_px, file, .. } = Options::new(options)?;
            if card_px.is_some() && photos.len() > 1 {
                return Err(refused("card_px: a card is in one photo; give only this photo"));
            }
            let (moves, others): (Vec<Edit>, Vec<Edit>) = edits.into_iter().partition(Edit::is_move);
            let commands = |edits: Vec<Edit>| edits.into_iter().map(Edit::command).collect::<PyResult<Vec<Command>>>();
            request.add_moves(commands(moves)?, &settings);
            request.edits.extend(commands(others)?);
            let photos: Vec<rosto::Photo> = photos.iter().map(|photo| photo.0.clone()).collect();
            let found = py.detach(|| {
                let photos = observed(&photos, finder, thorough, (lens, card_px))?;
                MeshRequest { photos, ..request.clone() }.open()
            });
            Ok(Self { mesh: Mutex::new(found.map_err(refused_request)?), request, file })
        })
    }

    /// Positions in metres in the model's frame, shape `(V, 3)`.
    fn positions_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        guarded("photo", || from_vectors(py, self.locked().positions()))
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
        options: Named<'py>,
    ) -> PyResult<Vec<(String, Bound<'py, PyBytes>)>> {
        guarded("photo", || {
            let (stem, extension) = name.rsplit_once('.').unwrap_or((name, ""));
            let format = Format::from_id(&extension.to_lowercase()).ok_or_else(|| unknown_format(name))?;
            let OptionsOfFile { values, given } = self.file.with(options)?;
            self.request.check_file(format, &values, &given).map_err(refused_request)?;
            let written = py.detach(|| self.locked().write(format, &values, stem)).map_err(refused_request)?;
            let sidecars = written.sidecars.into_iter().map(|file| (file.name, file.bytes));
            let files = [(name.to_owned(), written.bytes)].into_iter().chain(sidecars);
            Ok(files.map(|(name, bytes)| (name, PyBytes::new(py, &bytes))).collect())
        })
    }
}

impl FaceMesh {
    fn locked(&self) -> MutexGuard<'_, rosto::FaceMesh> {
        // Writing does not change the face, even if it fails.
        self.mesh.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Observes the first face in each photo, with the given lens or its own, and the given card.
fn observed(
    photos: &[rosto::Photo],
    finder: &Finder,
    thorough: bool,
    (lens, card_px): (Option<PhotoLens>, Option<[[f64; 2]; 4]>),
) -> Result<Vec<Observation>, rosto::Error> {
    if !(1..=MAX_PHOTOS).contains(&photos.len()) {
        return Err(FaceError::PhotoCount { found: photos.len(), most: MAX_PHOTOS }.into());
    }
    let found = MeshRequest::found_in(photos, &finder.0, &options_of(thorough, None))?.photos.into_iter();
    let given = |photo: Observation| {
        let photo = lens.into_iter().fold(photo, Observation::with_lens);
        card_px.into_iter().fold(photo, Observation::with_card_px)
    };
    Ok(found.map(given).collect())
}

fn unknown_format(name: &str) -> PyErr {
    let formats = Format::ALL.map(|format| format!(".{}", format.id())).join(", ");
    refused(format!("{name}: unknown file extension; use one of {formats}"))
}
