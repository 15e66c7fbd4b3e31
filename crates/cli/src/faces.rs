//! Faces in photos.

use std::path::{Path, PathBuf};

use rosto_face::Observation;
use rosto_landmarks::{Face, FaceFinder, FindOptions, FoundFaces};
use rosto_photo::{Limits, Photo, PhotoError};

use crate::args::{CameraArguments, FindArguments};
use crate::error::CliError;
use crate::face_notes::notes_on_first;
use crate::input::{self, ReadError};

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
pub fn all(photo: &Photo, path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<FoundFaces, CliError> {
    let found = finder.find_with_progress(photo, options, |_| ())?;
    // Damaged networks can return any value.
    let non_finite =
        |face: &Face| face.landmarks.iter().position(|landmark| !landmark.iter().all(|value| value.is_finite()));
    match found.faces.iter().find_map(non_finite) {
        Some(landmark) => Err(CliError::NonFiniteLandmark { path: path.to_owned(), landmark }),
        None => Ok(found),
    }
}

/// Returns the landmarks of the first face in a photo, with notes on the choice.
pub fn first(
    photo: &Photo,
    path: &Path,
    finder: &FaceFinder,
    find: &FindArguments,
) -> Result<(Vec<[f32; 3]>, Vec<String>), CliError> {
    let found = all(photo, path, finder, &find.options(None))?;
    let notes = notes_on_first(path, photo, &found);
    let first = found.faces.into_iter().next().ok_or_else(|| CliError::NoFace { path: path.to_owned() })?;
    Ok((first.landmarks, notes))
}

/// Observes the first face in each photo, with the given lens or its own, and the given card; returns notes on the
/// choices.
pub fn observed(
    photos: &[(PathBuf, Photo)],
    finder: &FaceFinder,
    find: &FindArguments,
    camera: &CameraArguments,
) -> Result<(Vec<Observation>, Vec<String>), CliError> {
    let (mut observations, mut notes) = (Vec::new(), Vec::new());
    for (path, photo) in photos {
        let (landmarks, its_notes) = first(photo, path, finder, find)?;
        let observation = Observation::in_photo(photo, landmarks);
        let observation = camera.lens().into_iter().fold(observation, Observation::with_lens);
        observations.push(camera.card_px.into_iter().fold(observation, Observation::with_card_px));
        notes.extend(its_notes);
    }
    Ok((observations, notes))
}
