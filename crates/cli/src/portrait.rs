use std::path::Path;

use rosto_face::{FaceInput, FaceModel, Triangulation};
use rosto_landmarks::{Face, FaceFinder, FindOptions};
use rosto_photo::{Limits, Photo};

use crate::error::CliError;
use crate::files;

/// The texture needs no more than this, and the page hands over no more, so that both write the same file.
const MAX_PICTURE_SIDE_PX: u32 = 2048;

pub fn open(path: &Path) -> Result<Photo, CliError> {
    let bytes = files::read(path)?;
    let no_picture = |reason| CliError::NoPicture { path: path.to_owned(), reason };
    rosto_photo::decode(&bytes, &Limits::default()).map_err(no_picture)
}

/// The most certain face in a photo.
pub fn face(photo: &Photo, path: &Path, finder: &FaceFinder) -> Result<Face, CliError> {
    let faces = finder.find(photo, &FindOptions::default())?;
    faces.into_iter().next().ok_or_else(|| CliError::NoFace { path: path.to_owned() })
}

/// The model of a face in a photo, coloured at full resolution.
pub fn model(photo: &Photo, face: &Face, triangulation: Triangulation, path: &Path) -> Result<FaceModel, CliError> {
    let colour = |&[x, y, _]: &[f32; 3]| photo.colour_under(x.into(), y.into());
    let colours: Vec<[u8; 3]> = face.landmarks.iter().map(colour).collect();
    let input = FaceInput {
        landmarks: &face.landmarks,
        width: photo.width(),
        height: photo.height(),
        colours: &colours,
        picture: photo.scaled_down(MAX_PICTURE_SIDE_PX),
    };
    FaceModel::new(input, triangulation).map_err(|reason| CliError::NoModel { path: path.to_owned(), reason })
}
