mod each;
mod ledger;

use std::fs;
use std::path::{Path, PathBuf};

use rosto_export::{ExportedFile, Format, PLA_G_PER_CM3, SolidFacts, Units};
use rosto_face::{FaceModel, MAX_PHOTOS, Photo, PhotoLens};
use rosto_landmarks::FaceFinder;
use rosto_studio::{Anchors, Command, CoordinateFrame, Document, EditSpec, Rest, StudioError};

use crate::args::{EditArguments, MeshTask, SettingsArguments};
use crate::edits::ExpressionEdit;
use crate::encode;
use crate::error::CliError;
use crate::networks::Networks;
use crate::portrait::Portrait;
use crate::request::{self, Given};
use crate::{edits, files, networks, output, portrait, terminal, view_notes};

const MM_PER_M: f64 = 1000.0;

/// A command and its name in error messages.
#[derive(Debug, Clone)]
pub struct Step {
    name: String,
    command: Command,
}

impl Step {
    fn new(name: impl Into<String>, command: Command) -> Self {
        Self { name: name.into(), command }
    }
}

/// Runs `rosto mesh`.
pub fn run(task: &MeshTask, given: &Given<'_>, networks: Networks<'_>) -> Result<(), CliError> {
    // Options are checked before the photos are read.
    let is_batch = output::is_pattern(&task.output);
    if !is_batch {
        check_count(task.photos.len())?;
        check_files(&task.photos, &task.edits, &task.output)?;
    }
    let format = encode::format_of(&task.output)?;
    request::check(task, format, given)?;
    if is_batch {
        return each::run(task, &steps_of(task)?, format, networks);
    }
    check_sidecars(task, format)?;
    let steps = steps_of(task)?;
    let photos: Vec<Photo> = task.photos.iter().map(|path| portrait::open(path)).collect::<Result<_, _>>()?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let photos = task.photos.iter().map(PathBuf::as_path).zip(photos).collect();
    let (Edited { face, notes, .. }, written) =
        make(task, photos, &steps, format, &encode::name_of(&task.output), &finder)?;
    output::write_together(&task.output, &written.bytes, &written.sidecars)?;
    let only = || vec!["1 face found".to_owned()];
    (if notes.is_empty() { only() } else { notes }).iter().for_each(|note| terminal::note(note));
    terminal::note(&distance_note(&face));
    if let Some(solid) = &written.solid {
        body_notes(solid).iter().for_each(|line| terminal::note(line));
    }
    view_notes::report(&face, &task.photos)
}

/// Builds the edited face and encodes it; sidecar files share `name`.
fn make(
    task: &MeshTask,
    photos: Vec<(&Path, Photo)>,
    steps: &[Step],
    format: Format,
    name: &str,
    finder: &FaceFinder,
) -> Result<(Edited, ExportedFile), CliError> {
    let mut edited = edited_face(task, photos, steps, finder)?;
    let written = encode::encode(&edited.face, &mut edited.document, task, format, name)?;
    Ok((edited, written))
}

/// Edited face.
pub struct Edited {
    /// Model from the photos.
    pub face: FaceModel,
    pub document: Document,
    /// Messages about photos with several faces and about doubtful faces.
    pub notes: Vec<String>,
}

/// Builds the model of the face in these photos and applies the edits.
pub fn edited_face(
    task: &MeshTask,
    photos: Vec<(&Path, Photo)>,
    steps: &[Step],
    finder: &FaceFinder,
) -> Result<Edited, CliError> {
    let mut notes = Vec::new();
    let portraits = photos.into_iter().map(|(path, photo)| {
        let (face, its_notes) = portrait::face(&photo, path, finder, &task.find.options(None))?;
        notes.extend(its_notes);
        Ok(Portrait { path, lens: task.camera.lens(&photo), photo, face })
    });
    let portraits = portraits.collect::<Result<Vec<_>, CliError>>()?;
    let face = portrait::model_of(&portraits, task.mesh.topology)?;
    let document = edited(&face, steps.to_vec(), task.units, task.mesh.density)?;
    Ok(Edited { face, document, notes })
}

/// Measures of a printed body, and a warning if creases were smoothed.
fn body_notes(solid: &SolidFacts) -> Vec<String> {
    let [width, height, depth] = solid.size_mm.to_array();
    let (volume, mass) = (solid.volume_cm3, solid.mass_g(PLA_G_PER_CM3));
    let mut lines = vec![format!(
        "a body of {volume:.1} cm³, {width:.0} × {height:.0} × {depth:.0} mm, {mass:.0} g in solid PLA; {:.1} mm at its thinnest",
        solid.thinnest_mm
    )];
    if solid.moved_mm > 0.0 {
        lines.push(format!("sharp creases were smoothed by up to {:.1} mm to fit the wall", solid.moved_mm));
    }
    lines
}

/// Refuses standard input as two inputs, and an output that is also an input.
pub fn check_files(photos: &[PathBuf], edits: &EditArguments, output: &Path) -> Result<(), CliError> {
    let inputs: Vec<&Path> = photos.iter().chain(&edits.file).map(PathBuf::as_path).collect();
    files::check_standard_input(inputs.iter().copied())?;
    output::check(output, &inputs)
}

fn check_count(given: usize) -> Result<(), CliError> {
    if given > MAX_PHOTOS { Err(CliError::TooManyPhotos { given }) } else { Ok(()) }
}

/// Refuses to replace a sidecar file that Rosto did not write for this output.
fn check_sidecars(task: &MeshTask, format: Format) -> Result<(), CliError> {
    let name = encode::name_of(&task.output);
    let sidecars =
        format.sidecar_names(task.base_colour, &name).into_iter().map(|name| task.output.with_file_name(name));
    let sidecars: Vec<PathBuf> = sidecars.collect();
    sidecars.iter().try_for_each(|path| check_files(&task.photos, &task.edits, path))?;
    let contents: Vec<Option<Vec<u8>>> = sidecars.iter().map(|path| fs::read(path).ok()).collect();
    match sidecars.iter().find(|path| path.exists()) {
        Some(path) if !task.batch.force && !format.wrote_sidecars(&name, &contents) => {
            Err(CliError::Foreign { path: path.clone(), for_file: task.output.clone() })
        }
        _ => Ok(()),
    }
}

/// Distance of the photo's camera and its source.
fn distance_note(face: &FaceModel) -> String {
    let camera = face.camera();
    let [distance_cm, error_cm] = [1.0, camera.distance_error].map(|share| share * camera.distance_m * 100.0);
    let known = match camera.lens {
        PhotoLens::Estimated => "estimated from the face",
        PhotoLens::Exif(_) => "from the photo's lens data",
        PhotoLens::Given(_) => "from the focal length given",
        PhotoLens::Distance(_) | PhotoLens::Parallel => return format!("taken from {distance_cm:.0} cm, as given"),
    };
    format!("taken from {distance_cm:.0} cm ± {error_cm:.0}, {known}")
}

/// Edits of `rosto mesh`.
pub fn steps_of(task: &MeshTask) -> Result<Vec<Step>, CliError> {
    steps(&task.edits, &task.settings, task.units)
}

/// Edits in the order that `--help` documents.
pub fn steps(asked: &EditArguments, settings: &SettingsArguments, units: Units) -> Result<Vec<Step>, CliError> {
    let unit = match units {
        Units::Image => 1.0,
        Units::Mm => 1.0 / MM_PER_M,
    };
    let mut steps = Vec::new();
    let mut edits = asked.file.as_deref().map(edits::read).transpose()?.unwrap_or_default();
    edits.extend(asked.vertices.iter().cloned());
    for edit in edits {
        let mut edit_settings = settings.for_edit(steps.len(), unit);
        if let Some(mut anchors) = edit.anchors {
            // Pins also apply to edits with explicit anchors.
            anchors.extend(settings.pins.iter().filter(|pin| !anchors.contains(pin)).copied().collect::<Vec<_>>());
            edit_settings.anchors = Anchors::explicit(anchors);
        }
        let name = match edit.level {
            0 => format!("vertex {}", edit.vertex),
            level => format!("vertex {}@{level}", edit.vertex),
        };
        let spec = EditSpec { level: edit.level, handles: vec![edit.vertex], settings: edit_settings };
        steps.push(Step::new(name, Command::Move { spec, offsets: vec![edit.offset * unit] }));
    }
    for edit in &asked.regions {
        let handles = edit.region.vertices();
        let offsets = vec![edit.offset * unit; handles.len()];
        let spec = EditSpec { level: 0, handles, settings: settings.for_edit(steps.len(), unit) };
        steps.push(Step::new(edit.region.id(), Command::Move { spec, offsets }));
    }
    for edit in &asked.sliders {
        steps.push(Step::new(edit.slider.id(), edit.slider.command(edit.amount_mm / MM_PER_M)));
    }
    for ExpressionEdit { expression, weight } in asked.expressions.iter().cloned() {
        steps.push(Step::new(expression.id(), Command::Express { expression, weight }));
    }
    if let Some(share) = asked.symmetrise {
        steps.push(Step::new("symmetrise", Command::Symmetrise { share }));
    }
    Ok(steps)
}

/// Builds a document of the face and applies the steps.
pub fn edited(face: &FaceModel, steps: Vec<Step>, units: Units, density: u32) -> Result<Document, CliError> {
    let rest = match units {
        Units::Image => {
            Rest::of_landmarks(face.topology().clone(), face.positions_image().to_vec(), CoordinateFrame::Other)
        }
        Units::Mm => Rest::of_face(face),
    };
    let mut document = Document::new(rest)?;
    document.set_density(density)?;
    for (index, Step { name, command }) in steps.into_iter().enumerate() {
        apply(&mut document, command).map_err(|reason| CliError::Edit { number: index + 1, name, reason })?;
    }
    Ok(document)
}

fn apply(document: &mut Document, command: Command) -> Result<(), StudioError> {
    // A document would let the edit wait for a denser mesh; a command has only one density.
    if let Command::Move { spec, .. } = &command
        && spec.level > document.density()
    {
        return Err(StudioError::TooCoarse { level: spec.level, density: document.density() });
    }
    // Same labels as the page, so that both write the same file.
    let label = command.target().to_string();
    document.apply(&label, command)
}
