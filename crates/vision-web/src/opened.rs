//! Faces of opened files.

use rosto::{FileKind, Limits, Observation, Photo, Reopened, SavedFace, Triangulation, decode, project, reopen, sniff};
use rosto_face::{FaceModel, MAX_PICTURE_SIDE_PX};
use rosto_landmarks::Face;

use crate::error::{self, Result};
use crate::messages::{OpenedFace, OpenedFile, OpenedKind, PhotoRemark};

/// A decoded file.
pub(crate) enum Decoded {
    /// A photo.
    Photo(Photo),
    /// A face that Rosto saved.
    Saved(Reopened),
}

/// Decodes a photo, GLB or project. `original` is the file from which the browser has converted the photo; the lens
/// data is read from it.
pub(crate) fn decoded(bytes: &[u8], original: Option<&[u8]>) -> Result<Decoded> {
    match sniff(bytes) {
        FileKind::Glb => Ok(Decoded::Saved(reopen(bytes).map_err(error::of_glb)?)),
        FileKind::Project => Ok(Decoded::Saved(project::read(bytes).map_err(error::of_project)?)),
        FileKind::Other => {
            let photo = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
            Ok(Decoded::Photo(match original {
                Some(original) => photo.with_lens_of(original),
                None => photo,
            }))
        }
    }
}

impl Decoded {
    /// The pictures of the file's photos.
    pub fn pictures(&self) -> Vec<Photo> {
        match self {
            Self::Photo(photo) => vec![photo.scaled_down(MAX_PICTURE_SIDE_PX)],
            Self::Saved(reopened) => {
                reopened.face.photos.iter().filter_map(|observation| observation.picture.clone()).collect()
            }
        }
    }
}

/// The faces found in a photo.
pub(crate) fn of_photo(photo: &Photo, faces: Vec<Face>, pictures: &[String]) -> OpenedFile {
    let faces = faces.into_iter().map(|face| {
        let remarks = rosto::PhotoRemark::of(photo, &face).into_iter().map(PhotoRemark::from).collect();
        let photos = vec![Observation::without_picture(photo, face.landmarks)];
        OpenedFace { remarks, ..opened(&SavedFace { photos, edits: None }, 0, pictures) }
    });
    OpenedFile { kind: OpenedKind::Photo, faces: faces.collect(), changed_elsewhere: false }
}

/// The face in a saved file.
pub(crate) fn of_saved(reopened: &Reopened, pictures: &[String]) -> Result<OpenedFile> {
    let Reopened { face, changed_elsewhere } = reopened;
    let edits = face.edits.as_ref().map(|edits| edits.to_json()).transpose();
    let edits = edits.map_err(|reason| error::of_request(reason.into()))?;
    let face = OpenedFace { edits, ..opened(face, lead(&face.photos)?, pictures) };
    Ok(OpenedFile { kind: OpenedKind::Saved, faces: vec![face], changed_elsewhere: *changed_elsewhere })
}

/// Index of the lead photo.
fn lead(photos: &[Observation]) -> Result<usize> {
    match photos {
        [_] => Ok(0),
        photos => {
            let model = FaceModel::from_photos(photos.to_vec(), Triangulation::Canonical);
            Ok(model.map_err(|reason| error::of_request(reason.into()))?.views()[0].photo)
        }
    }
}

fn opened(face: &SavedFace, lead: usize, pictures: &[String]) -> OpenedFace {
    let Observation { landmarks, photo_size_px, .. } = &face.photos[lead];
    OpenedFace {
        photos: face.photos_json(),
        edits: None,
        pictures: pictures.to_vec(),
        lead,
        size_px: *photo_size_px,
        landmarks: landmarks.concat(),
        remarks: Vec::new(),
    }
}
