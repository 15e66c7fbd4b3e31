mod each;
mod ledger;

use std::fs;
use std::path::{Path, PathBuf};

use rosto_export::{ExportedFile, Format, PLA_G_PER_CM3, SolidFacts, Units};
use rosto_face::{FaceModel, MOST_PHOTOS, Photo, PhotoLens};
use rosto_landmarks::FaceFinder;
use rosto_studio::{Anchors, Command, CoordinateFrame, Document, EditSpec, Rest, StudioError};

use crate::args::{EditArguments, MeshTask, SettingsArguments};
use crate::edits::ExpressionEdit;
use crate::encode;
use crate::error::CliError;
use crate::networks::Networks;
use crate::portrait::Portrait;
use crate::request::{self, Given};
use crate::{edits, files, networks, output, portrait, several, terminal};

const MM_PER_M: f64 = 1000.0;

/// A command with the words that a message names it by.
#[derive(Debug, Clone)]
pub struct Step {
    what: String,
    command: Command,
}

impl Step {
    fn new(what: impl Into<String>, command: Command) -> Self {
        Self { what: what.into(), command }
    }
}

/// `rosto mesh`: photo to edited mesh.
pub fn run(task: &MeshTask, given: &Given<'_>, networks: Networks<'_>) -> Result<(), CliError> {
    // What is wrong with the request is said before any work is done.
    let of_each = output::is_pattern(&task.output);
    if !of_each {
        check_count(task.photos.len())?;
        check_files(&task.photos, &task.edits, &task.output)?;
    }
    let format = encode::format_of(&task.output)?;
    request::check(task, format, given)?;
    if of_each {
        return each::run(task, &steps_of(task)?, format, networks);
    }
    check_beside(task, format)?;
    let steps = steps_of(task)?;
    let photos: Vec<Photo> = task.photos.iter().map(|path| portrait::open(path)).collect::<Result<_, _>>()?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let photos = task.photos.iter().map(PathBuf::as_path).zip(photos).collect();
    let (Edited { face, notes, .. }, written) =
        make(task, photos, &steps, format, &encode::name_of(&task.output), &finder)?;
    output::write_together(&task.output, &written.bytes, &written.sidecars)?;
    let only = || vec!["1 face found".to_owned()];
    (if notes.is_empty() { only() } else { notes }).iter().for_each(|note| terminal::note(note));
    terminal::note(&taken_from(&face));
    if let Some(solid) = &written.solid {
        told(solid).iter().for_each(|line| terminal::note(line));
    }
    several::tell(&face, &task.photos)
}

/// The face in these photos, and its file with those beside it, which are called `name`.
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

/// A face with its edits.
pub struct Edited {
    /// As the photos show it.
    pub face: FaceModel,
    /// Its edits.
    pub document: Document,
    /// For people: on photos with several faces, and faces that may not be any.
    pub notes: Vec<String>,
}

/// The face in these photos, edited.
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

/// What a printed body measures, and what its maker should know.
fn told(solid: &SolidFacts) -> Vec<String> {
    let [width, height, depth] = solid.size_mm.to_array();
    let (volume, mass) = (solid.volume_cm3, solid.mass_g(PLA_G_PER_CM3));
    let mut lines = vec![format!(
        "a body of {volume:.1} cm³, {width:.0} × {height:.0} × {depth:.0} mm, {mass:.0} g if it is filled with PLA; {:.1} mm where it is thinnest",
        solid.thinnest_mm
    )];
    if solid.moved_mm > 0.0 {
        lines.push(format!("sharp folds left no room for it, and were rounded off by up to {:.1} mm", solid.moved_mm));
    }
    lines
}

/// Refuses standard input for two things, and an output that is one of the inputs.
pub fn check_files(photos: &[PathBuf], edits: &EditArguments, output: &Path) -> Result<(), CliError> {
    let inputs: Vec<&Path> = photos.iter().chain(&edits.file).map(PathBuf::as_path).collect();
    files::check_standard_input(inputs.iter().copied())?;
    output::check(output, &inputs)
}

fn check_count(given: usize) -> Result<(), CliError> {
    if given > MOST_PHOTOS { Err(CliError::TooManyPhotos { given }) } else { Ok(()) }
}

/// Refuses to replace a file beside the output, which the command line does not name, unless Rosto wrote it for this output.
fn check_beside(task: &MeshTask, format: Format) -> Result<(), CliError> {
    let name = encode::name_of(&task.output);
    let beside = format.sidecar_names(task.base_colour, &name).into_iter().map(|name| task.output.with_file_name(name));
    let beside: Vec<PathBuf> = beside.collect();
    beside.iter().try_for_each(|path| check_files(&task.photos, &task.edits, path))?;
    let contents: Vec<Option<Vec<u8>>> = beside.iter().map(|path| fs::read(path).ok()).collect();
    match beside.iter().find(|path| path.exists()) {
        Some(path) if !task.many.force && !format.wrote_sidecars(&name, &contents) => {
            Err(CliError::Foreign { path: path.clone(), for_file: task.output.clone() })
        }
        _ => Ok(()),
    }
}

/// From how far away the photo was taken, and how that is known.
fn taken_from(face: &FaceModel) -> String {
    let camera = face.camera();
    let [distance_cm, error_cm] = [1.0, camera.distance_error].map(|share| share * camera.distance_m * 100.0);
    let known = match camera.lens {
        PhotoLens::Estimated => "read off the face",
        PhotoLens::Exif(_) => "from the photo's lens data",
        PhotoLens::Given(_) => "from the focal length given",
        PhotoLens::Distance(_) | PhotoLens::Parallel => return format!("taken from {distance_cm:.0} cm, as given"),
    };
    format!("taken from {distance_cm:.0} cm ± {error_cm:.0}, {known}")
}

/// All that was asked of `rosto mesh`.
pub fn steps_of(task: &MeshTask) -> Result<Vec<Step>, CliError> {
    steps(&task.edits, &task.settings, task.units)
}

/// All that was asked for, in the order that `--help` promises.
pub fn steps(asked: &EditArguments, settings: &SettingsArguments, units: Units) -> Result<Vec<Step>, CliError> {
    let unit = match units {
        Units::Image => 1.0,
        Units::Mm => 1.0 / MM_PER_M,
    };
    let mut steps = Vec::new();
    let mut edits = asked.file.as_deref().map(edits::read).transpose()?.unwrap_or_default();
    edits.extend(asked.vertices.iter().cloned());
    for edit in edits {
        let mut own = settings.of_edit(steps.len(), unit);
        if let Some(mut anchors) = edit.anchors {
            // Pins stay beside whatever else does.
            anchors.extend(settings.pins.iter().filter(|pin| !anchors.contains(pin)).copied().collect::<Vec<_>>());
            own.anchors = Anchors::explicit(anchors);
        }
        let what = match edit.level {
            0 => format!("vertex {}", edit.vertex),
            level => format!("vertex {}@{level}", edit.vertex),
        };
        let spec = EditSpec { level: edit.level, handles: vec![edit.vertex], settings: own };
        steps.push(Step::new(what, Command::Move { spec, offsets: vec![edit.offset * unit] }));
    }
    for edit in &asked.regions {
        let handles = edit.region.vertices();
        let offsets = vec![edit.offset * unit; handles.len()];
        let spec = EditSpec { level: 0, handles, settings: settings.of_edit(steps.len(), unit) };
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

/// The face with all of that done to it.
pub fn edited(face: &FaceModel, steps: Vec<Step>, units: Units, density: u32) -> Result<Document, CliError> {
    let rest = match units {
        Units::Image => Rest::new(face.topology().clone(), face.positions_image().to_vec(), CoordinateFrame::Other),
        Units::Mm => Rest::of_face(face),
    };
    let mut document = Document::new(rest)?;
    document.set_density(density)?;
    for (index, Step { what, command }) in steps.into_iter().enumerate() {
        apply(&mut document, command).map_err(|reason| CliError::Edit { number: index + 1, what, reason })?;
    }
    Ok(document)
}

fn apply(document: &mut Document, command: Command) -> Result<(), StudioError> {
    // A document lets such an edit wait for a denser mesh, and none will come here.
    if let Command::Move { spec, .. } = &command
        && spec.level > document.density()
    {
        return Err(StudioError::TooCoarse { level: spec.level, density: document.density() });
    }
    // The page calls its entries so, too: both write the same file.
    let label = command.target().to_string();
    document.apply(&label, command)
}
