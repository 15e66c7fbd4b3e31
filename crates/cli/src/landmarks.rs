use std::path::{Path, PathBuf};

use rosto_face::{FaceModel, Observation, Triangulation};
use rosto_landmarks::{Face, FaceFinder, FindOptions, FoundFaces};
use rosto_photo::Photo;
use serde::Serialize;
use serde_json::{Value, json};

use crate::args::LandmarksTask;
use crate::batch::{self, BatchSummary, Journal, Listing, Outcome, PhotoName, Progress};
use crate::error::CliError;
use crate::face_notes::notes_on_all;
use crate::{faces, files, networks, output, terminal};

#[derive(Serialize)]
struct PhotoDto<'a> {
    #[serde(flatten)]
    name: PhotoName<'a>,
    how: &'a Value,
    width: u32,
    height: u32,
    faces: Vec<FaceDto>,
    /// Lower bound for the number of faces, if `--max-faces` cut the list.
    #[serde(skip_serializing_if = "Option::is_none")]
    faces_at_least: Option<usize>,
}

#[derive(Serialize)]
struct FaceDto {
    score: f32,
    presence: f32,
    confidence: f32,
    /// The confidence, times how well the landmarks fit a face.
    quality: f64,
    landmarks: Vec<[f32; 3]>,
    /// Camera, pose and size of the face; absent if no model can be made.
    #[serde(skip_serializing_if = "Option::is_none")]
    about: Option<Value>,
}

impl FaceDto {
    fn new(photo: &Photo, face: Face) -> Self {
        let quality = (rosto::quality(photo, &face) * 1e4).round() / 1e4;
        let Face { score, presence, confidence, landmarks, .. } = face;
        let about = about(Observation::without_picture(photo, landmarks.clone()));
        Self { score, presence, confidence, quality, landmarks, about }
    }
}

fn about(observation: Observation) -> Option<Value> {
    let model = FaceModel::new(observation, Triangulation::Canonical).ok()?;
    Some(rosto_export::about(&model, model.positions_m()))
}

/// Line for a photo that failed, written only to a file.
#[derive(Serialize)]
struct FailureDto<'a> {
    #[serde(flatten)]
    name: PhotoName<'a>,
    how: &'a Value,
    error: String,
}

/// Runs `rosto landmarks`: writes a line per photo and reports photos that cannot be read.
pub fn run(task: &LandmarksTask, networks: Option<&Path>) -> Result<(), CliError> {
    files::check_standard_input(task.photos.iter().map(PathBuf::as_path))?;
    let photos = batch::photos(&task.photos)?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let options = task.find.options(task.max_faces);
    let how = how(task, &options);
    let mut lines = Lines::open(task, &photos, &how)?;
    let paths = photos.photos.iter().map(|photo| &photo.path);
    let left: Vec<PathBuf> = paths.filter(|photo| !lines.has(photo)).cloned().collect();
    let done = photos.photos.len() - left.len();
    let progress = Progress::new(photos.photos.len(), done, task.output.is_none());
    let mut summary = BatchSummary::default();
    let work = |photo: &Path| line(photo, &how, &finder, &options);
    batch::in_order(&left, task.batch.jobs, work, |(photo, outcome): Outcome<Line>| {
        let written = match &outcome {
            Ok(line) => {
                progress.note(&line.notes);
                lines.add(&line.json)
            }
            Err(error) => {
                progress.report(error);
                lines.add_failure(&photo, &how, error)
            }
        };
        summary.count(outcome.map(|line| line.faces > 0).as_ref());
        progress.step();
        written
    })?;
    drop(progress);
    if let Some(path) = &task.output {
        terminal::note(&summary.text(path, done, &photos.skipped));
    }
    summary.verdict()
}

/// Options that the landmarks depend on. A resumed file must have the same ones in each line.
fn how(task: &LandmarksTask, options: &FindOptions) -> Value {
    let search = if task.find.mediapipe { "mediapipe" } else { "thorough" };
    json!({ "search": search, "refined": !task.find.mediapipe || task.find.refine, "max_faces": options.max_faces })
}

/// Destination of the lines.
enum Lines {
    StandardOutput,
    File(Journal),
}

impl Lines {
    fn open(task: &LandmarksTask, photos: &Listing, how: &Value) -> Result<Self, CliError> {
        let Some(path) = &task.output else { return Ok(Self::StandardOutput) };
        let inputs: Vec<&Path> = photos.photos.iter().map(|photo| photo.path.as_path()).collect();
        output::check(path, &inputs)?;
        let journal = if task.batch.force { Journal::create(path) } else { Journal::open(path, how, photos) };
        journal.map(Self::File)
    }

    fn has(&self, photo: &Path) -> bool {
        matches!(self, Self::File(journal) if journal.has(photo))
    }

    fn add(&mut self, line: &str) -> Result<(), CliError> {
        match self {
            Self::StandardOutput => files::print(line),
            Self::File(journal) => journal.add(line),
        }
    }

    /// Adds a line with the error, which the next run replaces. Failures of the networks are not recorded.
    fn add_failure(&mut self, photo: &Path, how: &Value, error: &CliError) -> Result<(), CliError> {
        match self {
            Self::File(journal) if !error.is_network_failure() => {
                journal.add(&json(&FailureDto { name: PhotoName::new(photo), how, error: error.to_string() }))
            }
            _ => Ok(()),
        }
    }
}

/// JSON line of a photo, its number of faces, and notes for the user.
struct Line {
    json: String,
    faces: usize,
    notes: Vec<String>,
}

fn line(path: &Path, how: &Value, finder: &FaceFinder, options: &FindOptions) -> Result<Line, CliError> {
    let photo = faces::open(path)?;
    let found = faces::all(&photo, path, finder, options)?;
    let notes = notes_on_all(path, &photo, &found);
    let FoundFaces { faces, at_least } = found;
    let dto = PhotoDto {
        name: PhotoName::new(path),
        how,
        width: photo.width(),
        height: photo.height(),
        faces_at_least: (at_least > faces.len()).then_some(at_least),
        faces: faces.into_iter().map(|face| FaceDto::new(&photo, face)).collect(),
    };
    Ok(Line { json: json(&dto), faces: dto.faces.len(), notes })
}

fn json(dto: &impl Serialize) -> String {
    serde_json::to_string(dto).expect("invariant: numbers and text are JSON")
}
