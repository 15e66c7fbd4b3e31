use rosto_face::{FaceInput, FaceModel, MAX_DENSITY, Photo, PhotoLens, Triangulation};
use rosto_studio::{Amount, Document, Entry, Rest, project};

use crate::error::{SessionError, within};
use crate::further_photo::FurtherPhoto;
use crate::open_face::{MAX_OFFSET_M, OpenFace};
use crate::strokes;

/// How often a mesh is subdivided at most on the screen: [`MAX_DENSITY`] is for files.
pub const DENSEST_SHOWN: u32 = 3;

/// A history has no more entries than this.
pub const MOST_ENTRIES: usize = 100_000;

/// Everything that opens a face: what was found in a photo and, of earlier work, what was done since.
#[derive(Debug, Clone, PartialEq)]
pub struct Incoming {
    /// MediaPipe's normalised landmarks: 468, or 478 with the irises.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo that they were found in.
    pub photo_size_px: [u32; 2],
    /// The colour under each landmark, sRGB: 468.
    pub colours_srgb: Vec<[u8; 3]>,
    /// The upright picture, perhaps scaled down.
    pub picture: Photo,
    /// Lens data of the photo.
    pub lens: PhotoLens,
    /// Further photos of the same face, in the order that they were given in after this one; none of most faces.
    pub further: Vec<FurtherPhoto>,
    /// What was done to the face before; nothing for one that was just found.
    pub work: Option<Work>,
}

/// What was done to a face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Work {
    /// How the landmarks are joined.
    pub triangulation: Triangulation,
    /// How often the mesh was subdivided; a denser one than is shown opens as the densest that is.
    pub density: u32,
    /// The edits as versioned JSON.
    pub history: String,
    /// Data of the photo alone ([`OpenFace::photo_json`]); none where nothing was done to it.
    pub photo: Option<String>,
}

impl Work {
    fn entries(&self) -> Result<Vec<Entry>, SessionError> {
        let entries = project::from_json(&self.history)?;
        if entries.len() > MOST_ENTRIES {
            return Err(SessionError::TooManyEntries { found: entries.len(), most: MOST_ENTRIES });
        }
        entries.iter().map(|entry| entry.command.amount()).enumerate().try_for_each(check_amount)?;
        Ok(entries)
    }
}

/// Refuses what no hand can have done and no screen can show.
fn check_amount((entry, amount): (usize, Amount)) -> Result<(), SessionError> {
    match amount {
        Amount::Distance(distance_m) if !distance_m.is_finite() || distance_m.abs() > MAX_OFFSET_M => {
            Err(SessionError::BadHistory { entry, distance_m, most_m: MAX_OFFSET_M })
        }
        _ => Ok(()),
    }
}

/// The face with its work done to it, or why it cannot be opened. `triangulation` and `density` are for a face that brings
/// none of its own.
pub(crate) fn opened(incoming: Incoming, usual: (Triangulation, u32)) -> Result<OpenFace, SessionError> {
    let (triangulation, density, entries) = match &incoming.work {
        Some(work) => {
            within("the density", work.density.into(), 0.0, MAX_DENSITY.into())?;
            (work.triangulation, work.density.min(DENSEST_SHOWN), work.entries()?)
        }
        None => (usual.0, usual.1, Vec::new()),
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
