//! Implementation of `rosto mesh`.

mod each;
mod ledger;

use std::fs;
use std::path::{Path, PathBuf};

use rosto::{ExportedFile, FaceMesh, FileOptions, Format, MeshRequest};
use rosto_export::{PrintPose, SolidFacts};
use rosto_face::{FaceModel, MAX_PHOTOS, PhotoLens};
use rosto_landmarks::FaceFinder;
use rosto_photo::Photo;

use crate::args::{EditArguments, MeshTask};
use crate::effect::{self, Given};
use crate::error::CliError;
use crate::{faces, files, networks, output, terminal, view_notes};

/// A checked request of which only the photos are missing.
#[derive(Debug)]
struct Template<'a> {
    task: &'a MeshTask,
    request: MeshRequest,
    format: Format,
    file: FileOptions,
}

/// Runs `rosto mesh`.
pub fn run(task: &MeshTask, given: &Given<'_>, networks: Option<&Path>) -> Result<(), CliError> {
    // Options are checked before the photos are read.
    let is_batch = output::is_pattern(&task.output);
    if !is_batch {
        check_count(task.photos.len())?;
        check_files(&task.photos, &task.edits, &task.output)?;
    }
    let template = Template::new(task, given)?;
    if is_batch {
        return each::run(&template, networks);
    }
    check_sidecars(&template)?;
    let photos = task.photos.iter().map(|path| Ok((path.clone(), faces::open(path)?)));
    let photos: Vec<(PathBuf, Photo)> = photos.collect::<Result<_, CliError>>()?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let Made { mesh, written, notes } = template.make(&photos, &files::name_of(&task.output), &finder)?;
    output::write_together(&task.output, &written.bytes, &written.sidecars)?;
    let only = || vec!["1 face found".to_owned()];
    (if notes.is_empty() { only() } else { notes }).iter().for_each(|note| terminal::note(note));
    terminal::note(&distance_note(mesh.face()));
    if let Some(solid) = &written.solid {
        body_notes(solid).iter().for_each(|line| terminal::note(line));
    }
    view_notes::report(mesh.face(), &task.photos)
}

/// A mesh and its file.
struct Made {
    mesh: FaceMesh,
    written: ExportedFile,
    /// Messages about photos with several faces and about doubtful faces.
    notes: Vec<String>,
}

impl<'a> Template<'a> {
    fn new(task: &'a MeshTask, given: &Given<'_>) -> Result<Self, CliError> {
        let format = files::format_of(&task.output)?;
        effect::check_settings(&task.edits, &task.settings, given)?;
        let (request, file) =
            (task.mesh.request(task.units, &task.edits, &task.settings)?, task.file.options(task.units));
        effect::check_file(task, &request, format, &file, given)?;
        Ok(Self { task, request, format, file })
    }

    /// Builds the edited face in these photos and encodes it; sidecar files share `name`.
    fn make(&self, photos: &[(PathBuf, Photo)], name: &str, finder: &FaceFinder) -> Result<Made, CliError> {
        let paths: Vec<&Path> = photos.iter().map(|(path, _)| path.as_path()).collect();
        let refused = |reason| CliError::in_photos(reason, &paths);
        let (photos, notes) = faces::observed(photos, finder, &self.task.find, &self.task.camera)?;
        let mut mesh = MeshRequest { photos, ..self.request.clone() }.open().map_err(refused)?;
        let written = mesh.write(self.format, &self.file, name).map_err(refused)?;
        Ok(Made { mesh, written, notes })
    }
}

/// Measures of a printed body, warnings about thin walls and smoothed creases, and how to print it.
fn body_notes(solid: &SolidFacts) -> Vec<String> {
    let [width, height, depth] = solid.size_mm.to_array();
    let SolidFacts { volume_cm3, pla_g, asked_mm, thinnest_mm, thin_share, overhang_cm2, .. } = solid;
    let mut lines = vec![format!(
        "a body of {volume_cm3:.1} cm³, {width:.0} × {height:.0} × {depth:.0} mm, {pla_g:.0} g in PLA with 15 % infill; \
         {thinnest_mm:.1} mm at its thinnest"
    )];
    if *thin_share > 0.0 {
        lines.push(format!(
            "the wall is thinner than {asked_mm} mm on {:.0} % of the face: it may break there",
            (100.0 * thin_share).max(1.0)
        ));
    }
    let pose = match solid.pose {
        PrintPose::Lying => "lying on its back",
        PrintPose::Upright => "upright",
    };
    lines.push(match *overhang_cm2 > 0.0 {
        true => format!("print it {pose}, with supports: {:.0} cm² overhang", overhang_cm2.max(1.0)),
        false => format!("print it {pose}, without supports"),
    });
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
fn check_sidecars(template: &Template<'_>) -> Result<(), CliError> {
    let Template { task, format, file, .. } = template;
    let name = files::name_of(&task.output);
    let sidecars =
        format.sidecar_names(file.base_colour, &name).into_iter().map(|name| task.output.with_file_name(name));
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

/// Distance of the photo's camera, its 90 % interval and its source.
fn distance_note(face: &FaceModel) -> String {
    let camera = face.camera();
    let distance_cm = camera.distance_m * 100.0;
    let known = match camera.lens {
        PhotoLens::Estimated => "estimated from the face",
        PhotoLens::Exif(_) => "from the photo's lens data",
        PhotoLens::Given(_) => "from the focal length given",
        PhotoLens::Distance(_) | PhotoLens::Parallel => return format!("taken from {distance_cm:.0} cm, as given"),
    };
    let [nearest_cm, farthest_cm] = camera.distance_interval_m.map(|end_m| end_m * 100.0);
    format!("taken from {distance_cm:.0} cm ({nearest_cm:.0} to {farthest_cm:.0}), {known}")
}
