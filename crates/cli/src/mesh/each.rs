//! One mesh per photo.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use super::ledger::{Ledger, Status};
use super::{Made, Template};
use crate::args::MeshTask;
use crate::batch::{self, BatchSummary, Listing, Outcome, Progress};
use crate::error::CliError;
use crate::{faces, files, networks, output, terminal};

/// A photo and its output files, the mesh first.
struct Job {
    photo: PathBuf,
    outputs: Vec<PathBuf>,
}

/// Makes the missing meshes. Failed photos are skipped; a failed write ends the batch.
pub fn run(template: &Template<'_>, networks: Option<&Path>) -> Result<(), CliError> {
    let task = template.task;
    files::check_standard_input(task.photos.iter().chain(&task.edits.file).map(PathBuf::as_path))?;
    let listing = batch::photos(&task.photos)?;
    let jobs = jobs(template, &listing);
    check_names(&jobs, task)?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let ledger = Ledger::open(&task.output, &request(template))?;
    let left = match left(&jobs, &ledger, task.batch.force) {
        Ok(left) => left,
        Err(refused) => {
            ledger.discard_empty()?;
            return Err(refused);
        }
    };
    let by_photo: HashMap<&Path, &Job> = jobs.iter().map(|job| (&*job.photo, job)).collect();
    let done = jobs.len() - left.len();
    let progress = Progress::new(jobs.len(), done, false);
    let mut summary = BatchSummary::default();
    let is_stopped = AtomicBool::new(false);
    let work = |path: &Path| {
        if is_stopped.load(Ordering::Relaxed) {
            return Ok(Vec::new());
        }
        let output = &by_photo[path].outputs[0];
        let photos = [(path.to_owned(), faces::open(path)?)];
        let Made { written, notes, .. } = template.make(&photos, &files::name_of(output), &finder)?;
        ledger.add(path, &written)?;
        make_folder_of(output)?;
        output::write_together(output, &written.bytes, &written.sidecars)?;
        Ok(notes)
    };
    let work = |path: &Path| {
        let outcome = work(path);
        is_stopped.fetch_or(outcome.as_ref().is_err_and(CliError::is_write_failure), Ordering::Relaxed);
        outcome
    };
    batch::in_order(&left, task.batch.jobs, work, |(_, outcome): Outcome<Vec<String>>| {
        match outcome {
            Err(error) if error.is_write_failure() => return Err(error),
            Err(ref error) => progress.report(error),
            Ok(ref notes) => progress.note(notes),
        }
        summary.count(outcome.map(|_| true).as_ref());
        progress.step();
        Ok(())
    })?;
    drop(progress);
    terminal::note(&summary.text(&task.output, done, &listing.skipped));
    summary.verdict()
}

/// Identifies the options and edits that determine the meshes.
fn request(Template { task, request, file, .. }: &Template<'_>) -> String {
    format!("{:?}", (request, file, &task.find, &task.camera))
}

/// One job per photo; `{}` in the pattern becomes the photo's path relative to the given folder.
fn jobs(Template { task, format, file, .. }: &Template<'_>, listing: &Listing) -> Vec<Job> {
    let pattern = task.output.to_string_lossy();
    let job = |photo: &batch::Listed| {
        let name = photo.name.with_extension("");
        let output = PathBuf::from(filled(&pattern, &name));
        let sidecars = format.sidecar_names(file.base_colour, &files::name_of(&output));
        let sidecars = sidecars.into_iter().map(|name| output.with_file_name(name));
        Job { photo: photo.path.clone(), outputs: [output.clone()].into_iter().chain(sidecars).collect() }
    };
    listing.photos.iter().map(job).collect()
}

/// Replaces `{}` by the name, which need not be UTF-8.
fn filled(pattern: &str, name: &Path) -> OsString {
    let mut filled = OsString::new();
    for (index, part) in pattern.split(output::PHOTO_NAME).enumerate() {
        if index > 0 {
            filled.push(name);
        }
        filled.push(part);
    }
    filled
}

/// Refuses outputs that coincide with each other or with an input.
fn check_names(jobs: &[Job], task: &MeshTask) -> Result<(), CliError> {
    let inputs = jobs.iter().map(|job| &job.photo).chain(&task.edits.file);
    let inputs: HashMap<PathBuf, &PathBuf> =
        inputs.filter_map(|input| Some((input.canonicalize().ok()?, input))).collect();
    let mut by_output: HashMap<PathBuf, &Job> = HashMap::new();
    for job in jobs {
        for output in &job.outputs {
            if let Some(other) = by_output.insert(folded(output), job) {
                let [one, other] = [&other.photo, &job.photo].map(Clone::clone);
                return Err(CliError::SameOutput { one, other, path: output.clone() });
            }
            if let Some(input) = output.canonicalize().ok().and_then(|output| inputs.get(&output)) {
                return Err(CliError::OverwritesInput { input: input.to_path_buf(), path: output.clone() });
            }
        }
    }
    Ok(())
}

/// File systems of macOS and Windows usually ignore case.
fn folded(output: &Path) -> PathBuf {
    match cfg!(any(target_os = "macos", windows)) {
        true => output.to_string_lossy().to_lowercase().into(),
        false => output.to_owned(),
    }
}

/// Photos whose meshes are missing or outdated; fails if an output is a file that Rosto did not write.
fn left(jobs: &[Job], ledger: &Ledger, force: bool) -> Result<Vec<PathBuf>, CliError> {
    let mut left = Vec::new();
    for job in jobs {
        if force || ledger.status(&job.photo, &job.outputs)? == Status::ToDo {
            left.push(job.photo.clone());
        }
    }
    Ok(left)
}

fn make_folder_of(output: &Path) -> Result<(), CliError> {
    let folder = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|reason| CliError::Unwritable { path: output.to_owned(), reason })
}
