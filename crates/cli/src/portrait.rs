use std::path::Path;

use rosto_face::{FaceInput, FaceModel, LANDMARK_COUNT, PhotoLens, Triangulation};
use rosto_landmarks::{Face, FaceFinder, FindOptions};
use rosto_photo::{Limits, Photo, PhotoError};

use crate::error::CliError;
use crate::files::{self, ReadError};

/// The texture needs no more than this, and the page hands over no more, so that both write the same file.
const MAX_PICTURE_SIDE_PX: u32 = 2048;

/// Reads no more of the file than a picture may have.
pub fn open(path: &Path) -> Result<Photo, CliError> {
    let limits = Limits::default();
    let no_picture = |reason| CliError::NoPicture { path: path.to_owned(), reason };
    let bytes = files::read(path, limits.max_bytes).map_err(|reason| match reason {
        ReadError::TooManyBytes { found_bytes, max_bytes } => {
            no_picture(PhotoError::TooManyBytes { found_bytes: found_bytes as u64, max_bytes: max_bytes as u64 })
        }
        reason => CliError::Unreadable { path: path.to_owned(), reason },
    })?;
    rosto_photo::decode(&bytes, &limits).map_err(no_picture)
}

/// The faces in a photo in the order of the search, every landmark with a place.
pub fn faces(photo: &Photo, path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<Vec<Face>, CliError> {
    let faces = finder.find(photo, options)?;
    // A network whose weights are not what they were may answer with anything.
    let nowhere = |face: &Face| face.landmarks.iter().position(|place| !place.iter().all(|at| at.is_finite()));
    match faces.iter().find_map(nowhere) {
        Some(landmark) => Err(CliError::NoPlace { path: path.to_owned(), landmark }),
        None => Ok(faces),
    }
}

/// The most prominent face in a photo.
pub fn face(photo: &Photo, path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<Face, CliError> {
    let faces = faces(photo, path, finder, options)?;
    faces.into_iter().next().ok_or_else(|| CliError::NoFace { path: path.to_owned() })
}

/// What is known of a face beside where its landmarks are.
pub fn about(photo: &Photo, face: &Face) -> Option<serde_json::Value> {
    let colours = [[0; 3]; LANDMARK_COUNT];
    let picture = Photo::from_rgb(1, 1, vec![0; 3]).ok()?;
    let (landmarks, width, height) = (face.landmarks.as_slice(), photo.width(), photo.height());
    let input = FaceInput { landmarks, width, height, colours: &colours, picture, lens: lens_of(photo) };
    let model = FaceModel::new(input, Triangulation::Canonical).ok()?;
    Some(rosto_export::about(&model, model.positions_m()))
}

/// What the photo tells of its lens.
pub fn lens_of(photo: &Photo) -> PhotoLens {
    photo.focal_length_35mm().map_or(PhotoLens::Estimated, PhotoLens::Exif)
}

/// The model of a face in a photo, coloured at full resolution.
pub fn model(
    photo: &Photo,
    face: &Face,
    triangulation: Triangulation,
    lens: PhotoLens,
    path: &Path,
) -> Result<FaceModel, CliError> {
    let colour = |&[x, y, _]: &[f32; 3]| photo.colour_under(x.into(), y.into());
    let colours: Vec<[u8; 3]> = face.landmarks.iter().take(LANDMARK_COUNT).map(colour).collect();
    let input = FaceInput {
        landmarks: &face.landmarks,
        width: photo.width(),
        height: photo.height(),
        colours: &colours,
        picture: photo.scaled_down(MAX_PICTURE_SIDE_PX),
        lens,
    };
    FaceModel::new(input, triangulation).map_err(|reason| CliError::NoModel { path: path.to_owned(), reason })
}
