use std::path::Path;

use rosto_face::{FaceError, FaceInput, FaceModel, LANDMARK_COUNT, PhotoLens, Triangulation};
use rosto_landmarks::{Face, FaceFinder, FindOptions, FoundFaces};
use rosto_photo::{Limits, Photo, PhotoError};

use crate::error::CliError;
use crate::found::notes_on_first;
use crate::input::{self, ReadError};

/// The texture needs no more than this, and the page hands over no more, so that both write the same file.
const MAX_PICTURE_SIDE_PX: u32 = 2048;

/// Reads no more of the file than a picture may have.
pub fn open(path: &Path) -> Result<Photo, CliError> {
    let limits = Limits::default();
    let no_picture = |reason| CliError::NoPicture { path: path.to_owned(), reason };
    let bytes = input::read(path, limits.max_bytes).map_err(|reason| match reason {
        ReadError::TooManyBytes { found_bytes, max_bytes } => {
            no_picture(PhotoError::TooManyBytes { found_bytes: found_bytes as u64, max_bytes: max_bytes as u64 })
        }
        reason => CliError::Unreadable { path: path.to_owned(), reason },
    })?;
    rosto_photo::decode(&bytes, &limits).map_err(no_picture)
}

/// The faces in a photo in the order of the search, every landmark with a place.
pub fn faces(photo: &Photo, path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<FoundFaces, CliError> {
    let found = finder.find_with_progress(photo, options, |_| ())?;
    // A network whose weights are not what they were may answer with anything.
    let nowhere = |face: &Face| face.landmarks.iter().position(|place| !place.iter().all(|at| at.is_finite()));
    match found.faces.iter().find_map(nowhere) {
        Some(landmark) => Err(CliError::NoPlace { path: path.to_owned(), landmark }),
        None => Ok(found),
    }
}

/// The first face in a photo, with notes on the choice.
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
    let colours = colours(photo, face);
    FaceModel::new(input(photo, face, &colours, lens), triangulation)
        .map_err(|reason| CliError::NoModel { path: path.to_owned(), reason })
}

/// One of the photos of a face.
pub struct Portrait<'a> {
    pub path: &'a Path,
    pub photo: Photo,
    pub face: Face,
    pub lens: PhotoLens,
}

/// The model of the face in one photo or several, coloured as the one that leads.
pub fn model_of(portraits: &[Portrait<'_>], triangulation: Triangulation) -> Result<FaceModel, CliError> {
    let colours: Vec<_> = portraits.iter().map(|of| colours(&of.photo, &of.face)).collect();
    let inputs = portraits.iter().zip(&colours).map(|(of, colours)| input(&of.photo, &of.face, colours, of.lens));
    FaceModel::of_several(inputs.collect(), triangulation).map_err(|reason| match reason {
        FaceError::InPhoto { photo, reason } => {
            CliError::NoModel { path: portraits[photo].path.to_owned(), reason: *reason }
        }
        FaceError::AnotherFace { photo, reprojection_px, most_px } => {
            CliError::AnotherFace { path: portraits[photo].path.to_owned(), reprojection_px, most_px }
        }
        reason => CliError::NoModel { path: portraits[0].path.to_owned(), reason },
    })
}

/// The pixel under each landmark at full resolution.
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
