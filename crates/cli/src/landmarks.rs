use std::path::Path;

use rosto_landmarks::{FaceFinder, FindOptions};
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
    landmarks: Vec<[f32; 3]>,
}

/// `rosto landmarks`: a line for each photo that can be read, a message for each that cannot.
pub fn run(task: &LandmarksTask, networks: Option<&Path>) -> Result<(), CliError> {
    let finder = networks::load(networks)?;
    let options = FindOptions { max_faces: task.max_faces, ..FindOptions::default() };
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
    match failures.len() {
        0 => Ok(()),
        count => Err(CliError::SomePhotosFailed { count }),
    }
}

fn line(path: &Path, finder: &FaceFinder, options: &FindOptions) -> Result<String, CliError> {
    let photo = portrait::open(path)?;
    let faces = finder.find(&photo, options)?;
    let dto = PhotoDto {
        photo: path.to_string_lossy(),
        width: photo.width(),
        height: photo.height(),
        faces: faces.into_iter().map(|face| FaceDto { score: face.score, landmarks: face.landmarks }).collect(),
    };
    Ok(serde_json::to_string(&dto).expect("invariant: numbers and text are JSON"))
}
