use std::path::Path;

use rosto_landmarks::{Face, FaceFinder, FindOptions};
use rosto_photo::Photo;
use serde::Serialize;

use crate::args::LandmarksTask;
use crate::error::CliError;
use crate::{files, networks, portrait};

#[derive(Serialize)]
struct PhotoDto<'a> {
    photo: std::borrow::Cow<'a, str>,
    width: u32,
    height: u32,
    faces: Vec<FaceDto>,
}

#[derive(Serialize)]
struct FaceDto {
    score: f32,
    presence: f32,
    confidence: f32,
    landmarks: Vec<[f32; 3]>,
    /// How the photo was taken, how the head is turned, and how large the face is; none of what is no model.
    #[serde(skip_serializing_if = "Option::is_none")]
    about: Option<serde_json::Value>,
}

impl FaceDto {
    fn new(photo: &Photo, face: Face) -> Self {
        let about = portrait::about(photo, &face);
        let Face { score, presence, confidence, landmarks, .. } = face;
        Self { score, presence, confidence, landmarks, about }
    }
}

/// `rosto landmarks`: a line for each photo that can be read, a message for each that cannot.
pub fn run(task: &LandmarksTask, networks: Option<&Path>) -> Result<(), CliError> {
    if task.photos.iter().filter(|photo| files::is_standard_input(photo)).count() > 1 {
        return Err(CliError::StandardInputTwice);
    }
    let finder = networks::load(networks, task.find.landmarks())?;
    let options = task.find.options(task.max_faces);
    let mut failures = Vec::new();
    for photo in &task.photos {
        match line(photo, &finder, &options) {
            Ok(line) => files::print(&line)?,
            Err(error) => {
                error.report();
                failures.push(error);
            }
        }
    }
    let by_networks = failures.iter().filter(|failure| failure.is_of_networks()).count();
    match (failures.len(), by_networks) {
        (0, _) => Ok(()),
        (count, 0) => Err(CliError::SomePhotosFailed { count }),
        (count, by_networks) => Err(CliError::NetworksFailed { count, by_networks }),
    }
}

fn line(path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<String, CliError> {
    let photo = portrait::open(path)?;
    let faces = portrait::faces(&photo, path, finder, options)?;
    let dto = PhotoDto {
        photo: path.to_string_lossy(),
        width: photo.width(),
        height: photo.height(),
        faces: faces.into_iter().map(|face| FaceDto::new(&photo, face)).collect(),
    };
    Ok(serde_json::to_string(&dto).expect("invariant: numbers and text are JSON"))
}
