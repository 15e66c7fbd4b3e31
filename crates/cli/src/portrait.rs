use std::path::Path;

use rosto_face::{FaceError, FaceInput, FaceModel, LANDMARK_COUNT, PhotoLens, Triangulation};
use rosto_landmarks::{Face, FaceFinder, FindOptions, FoundFaces};
use rosto_photo::{Limits, Photo, PhotoError};

use crate::error::CliError;
use crate::face_notes::notes_on_first;
use crate::input::{self, ReadError};

/// Largest picture side for the texture; the page uses the same limit, so that both write the same file.
const MAX_PICTURE_SIDE_PX: u32 = 2048;

/// Decodes a photo, reading no more bytes than the limits allow.
pub fn open(path: &Path) -> Result<Photo, CliError> {
    let limits = Limits::default();
    let no_picture = |reason| CliError::InvalidPicture { path: path.to_owned(), reason };
    let bytes = input::read(path, limits.max_bytes).map_err(|reason| match reason {
        ReadError::TooManyBytes { found_bytes, max_bytes } => {
            no_picture(PhotoError::TooManyBytes { found_bytes: found_bytes as u64, max_bytes: max_bytes as u64 })
        }
        reason => CliError::Unreadable { path: path.to_owned(), reason },
    })?;
    rosto_photo::decode(&bytes, &limits).map_err(no_picture)
}

/// Finds the faces in a photo and checks that their landmarks are finite.
pub fn faces(photo: &Photo, path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<FoundFaces, CliError> {
    let found = finder.find_with_progress(photo, options, |_| ())?;
    // Damaged networks can return any value.
    let non_finite =
        |face: &Face| face.landmarks.iter().position(|landmark| !landmark.iter().all(|value| value.is_finite()));
    match found.faces.iter().find_map(non_finite) {
        Some(landmark) => Err(CliError::NonFiniteLandmark { path: path.to_owned(), landmark }),
        None => Ok(found),
    }
}

/// Returns the first face in a photo, with notes on the choice.
pub fn face(
    photo: &Photo,
    path: &Path,
    finder: &FaceFinder,
    options: &FindOptions,
) -> Result<(Face, Vec<String>), CliError> {
    let found = faces(photo, path, finder, options)?;
    let notes = notes_on_first(path, photo, &found);
    let first = found.faces.into_iter().next().ok_or_else(|| CliError::NoFace { path: path.to_owned() })?;
    Ok((first, notes))
}

/// JSON about a face's camera, pose and size; `None` if no model can be made.
pub fn about(photo: &Photo, face: &Face) -> Option<serde_json::Value> {
    let colours = [[0; 3]; LANDMARK_COUNT];
    let picture = Photo::from_rgb(1, 1, vec![0; 3]).ok()?;
    let (landmarks, width, height) = (face.landmarks.as_slice(), photo.width(), photo.height());
    let input = FaceInput { landmarks, width, height, colours: &colours, picture, lens: lens_of(photo) };
    let model = FaceModel::new(input, Triangulation::Canonical).ok()?;
    Some(rosto_export::about(&model, model.positions_m()))
}

/// Lens data from the photo's metadata, if any.
pub fn lens_of(photo: &Photo) -> PhotoLens {
    photo.focal_length_35mm().map_or(PhotoLens::Estimated, PhotoLens::Exif)
}

/// Model of a face in a photo, coloured at full resolution.
pub fn model(
    photo: &Photo,
    face: &Face,
    triangulation: Triangulation,
    lens: PhotoLens,
    path: &Path,
) -> Result<FaceModel, CliError> {
    let colours = colours(photo, face);
    FaceModel::new(input(photo, face, &colours, lens), triangulation)
        .map_err(|reason| CliError::NoModel { path: path.to_owned(), reason })
}

/// A face and its photo.
pub struct Portrait<'a> {
    pub path: &'a Path,
    pub photo: Photo,
    pub face: Face,
    pub lens: PhotoLens,
}

/// Model of the face in one or more photos, with the lead photo's colours.
pub fn model_of(portraits: &[Portrait<'_>], triangulation: Triangulation) -> Result<FaceModel, CliError> {
    let colours: Vec<_> = portraits.iter().map(|of| colours(&of.photo, &of.face)).collect();
    let inputs = portraits.iter().zip(&colours).map(|(of, colours)| input(&of.photo, &of.face, colours, of.lens));
    FaceModel::from_photos(inputs.collect(), triangulation).map_err(|reason| match reason {
        FaceError::InPhoto { photo, reason } => {
            CliError::NoModel { path: portraits[photo].path.to_owned(), reason: *reason }
        }
        FaceError::AnotherFace { photo, reprojection_px, most_px } => {
            CliError::AnotherFace { path: portraits[photo].path.to_owned(), reprojection_px, most_px }
        }
        reason => CliError::NoModel { path: portraits[0].path.to_owned(), reason },
    })
}

/// Colour of the pixel at each landmark, at full resolution.
fn colours(photo: &Photo, face: &Face) -> Vec<[u8; 3]> {
    let colour = |&[x, y, _]: &[f32; 3]| photo.colour_under(x.into(), y.into());
    face.landmarks.iter().take(LANDMARK_COUNT).map(colour).collect()
}

fn input<'a>(photo: &Photo, face: &'a Face, colours: &'a [[u8; 3]], lens: PhotoLens) -> FaceInput<'a> {
    FaceInput {
        landmarks: &face.landmarks,
        width: photo.width(),
        height: photo.height(),
        colours,
        picture: photo.scaled_down(MAX_PICTURE_SIDE_PX),
        lens,
    }
}
