use rosto_face::{FaceInput, FaceModel, MAX_DENSITY, Photo, PhotoLens, Triangulation};
use rosto_studio::{Amount, Document, Entry, Rest, project};

use crate::error::{SessionError, within};
use crate::further_photo::FurtherPhoto;
use crate::open_face::{MAX_OFFSET_M, OpenFace};
use crate::strokes;

/// Highest density on the screen; files can have up to [`MAX_DENSITY`].
pub const MAX_SHOWN_DENSITY: u32 = 3;

/// Maximum length of a history.
pub const MAX_ENTRIES: usize = 100_000;

/// Data from which a face opens: the detection in a photo and, for earlier work, the edits.
#[derive(Debug, Clone, PartialEq)]
pub struct Incoming {
    /// MediaPipe's normalised landmarks: 468, or 478 with the irises.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// Colour at each landmark, sRGB: 468.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The upright picture; it can be scaled down.
    pub picture: Photo,
    /// Lens data of the photo.
    pub lens: PhotoLens,
    /// Further photos of the same face, in the order in which they were added; usually none.
    pub further: Vec<FurtherPhoto>,
    /// Earlier edits; `None` for a newly detected face.
    pub work: Option<Work>,
}

/// Edits of a face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Work {
    /// Triangulation of the landmarks.
    pub triangulation: Triangulation,
    /// Density of the mesh; clamped to the highest displayed density.
    pub density: u32,
    /// The edits as versioned JSON.
    pub history: String,
    /// Photo-edit data ([`OpenFace::photo_json`]); `None` without photo edits.
    pub photo: Option<String>,
}

impl Work {
    fn entries(&self) -> Result<Vec<Entry>, SessionError> {
        let entries = project::from_json(&self.history)?;
        if entries.len() > MAX_ENTRIES {
            return Err(SessionError::TooManyEntries { found: entries.len(), max: MAX_ENTRIES });
        }
        entries.iter().map(|entry| entry.command.amount()).enumerate().try_for_each(check_amount)?;
        Ok(entries)
    }
}

/// Rejects offsets beyond the maximum.
fn check_amount((entry, amount): (usize, Amount)) -> Result<(), SessionError> {
    match amount {
        Amount::Distance(distance_m) if !distance_m.is_finite() || distance_m.abs() > MAX_OFFSET_M => {
            Err(SessionError::BadHistory { entry, distance_m, most_m: MAX_OFFSET_M })
        }
        _ => Ok(()),
    }
}

/// Builds the face and applies its edits. `defaults` holds the triangulation and density of a face without earlier edits.
pub(crate) fn opened(incoming: Incoming, defaults: (Triangulation, u32)) -> Result<OpenFace, SessionError> {
    let (triangulation, density, entries) = match &incoming.work {
        Some(work) => {
            within("the density", work.density.into(), 0.0, MAX_DENSITY.into())?;
            (work.triangulation, work.density.min(MAX_SHOWN_DENSITY), work.entries()?)
        }
        None => (defaults.0, defaults.1, Vec::new()),
    };
    let photo = incoming.work.as_ref().and_then(|work| work.photo.as_deref());
    let photo = photo.map(strokes::read).transpose()?;
    let [width, height] = incoming.photo_size_px;
    let input = FaceInput {
        landmarks: &incoming.landmarks,
        width,
        height,
        colours: &incoming.colours_srgb,
        picture: incoming.picture,
        lens: incoming.lens,
    };
    let model = match incoming.further.as_slice() {
        [] => FaceModel::new(input, triangulation)?,
        further => {
            let further = further.iter().map(FurtherPhoto::input);
            FaceModel::from_photos(std::iter::once(input).chain(further).collect(), triangulation)?
        }
    };
    let document = Document::open(Rest::of_face(&model), entries, density)?;
    let mut face = OpenFace::new(model, document);
    if let Some((seen_from_m, strokes)) = photo {
        face.restore_photo(seen_from_m, strokes);
    }
    Ok(face)
}
