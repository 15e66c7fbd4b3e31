//! A mesh of each of many photos.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::fs;
use std::path::{Path, PathBuf};

use rosto_export::Format;

use super::{Step, make};
use crate::args::MeshTask;
use crate::error::CliError;
use crate::many::{self, Outcome, Progress, Told};
use crate::{encode, networks, output, portrait, terminal};

/// Stands for the name of a photo.
const NAME: &str = "{}";

/// Whether an output stands for one of each photo.
pub fn is_asked_for(output: &Path) -> bool {
    output.to_str().is_some_and(|output| output.contains(NAME))
}

/// Makes those that are not there; a photo that fails stops no other.
pub fn run(task: &MeshTask, steps: &[Step], format: Format, networks: Option<&Path>) -> Result<(), CliError> {
    let outputs = outputs(task)?;
    check_beside(task, format, &outputs)?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let left: Vec<PathBuf> =
        outputs.iter().filter(|(_, output)| !output.exists()).map(|(photo, _)| photo.clone()).collect();
    let by_photo: HashMap<&Path, &Path> = outputs.iter().map(|(photo, output)| (&**photo, &**output)).collect();
    let progress = Progress::new(outputs.len(), outputs.len() - left.len(), false);
    let mut told = Told::default();
    let work = |path: &Path| {
        let output = by_photo[path];
        let photo = portrait::open(path)?;
        let (_, written) = make(task, vec![(path, photo)], steps, format, &encode::name_of(output), &finder)?;
        make_folder_of(output)?;
        output::write_together(output, &written.bytes, &written.beside)?;
        Ok(true)
    };
    many::in_order(&left, task.many.jobs, work, |(_, outcome): Outcome<bool>| {
        outcome.as_ref().err().into_iter().for_each(|error| progress.report(error));
        told.count(outcome.as_ref());
        progress.step();
        Ok(())
    })?;
    drop(progress);
    terminal::note(&told.summary(&task.output, outputs.len() - left.len()));
    told.verdict()
}

/// Each photo, by its name below the folder that was given, with the file it becomes.
fn outputs(task: &MeshTask) -> Result<Vec<(PathBuf, PathBuf)>, CliError> {
    let pattern = task.output.to_string_lossy();
    let mut outputs = Vec::new();
    let mut by_output = HashMap::new();
    for given in &task.photos {
        let folder = if given.is_dir() { Some(given.as_path()) } else { given.parent() };
        for photo in many::photos(std::slice::from_ref(given))? {
            let name = folder.and_then(|folder| photo.strip_prefix(folder).ok()).unwrap_or(&photo).with_extension("");
            let output = PathBuf::from(pattern.replace(NAME, &name.to_string_lossy()));
            match by_output.entry(output.clone()) {
                Entry::Vacant(free) => drop(free.insert(photo.clone())),
                Entry::Occupied(taken) if *taken.get() == photo => continue,
                Entry::Occupied(taken) => {
                    return Err(CliError::SameOutput { one: taken.get().clone(), other: photo, path: output });
                }
            }
            outputs.push((photo, output));
        }
    }
    Ok(outputs)
}

/// Refuses to write over one of the photos: an output that is there is left alone, and so must be what lies beside it.
fn check_beside(task: &MeshTask, format: Format, outputs: &[(PathBuf, PathBuf)]) -> Result<(), CliError> {
    let photos: HashMap<PathBuf, &PathBuf> =
        outputs.iter().filter_map(|(photo, _)| Some((photo.canonicalize().ok()?, photo))).collect();
    for (_, output) in outputs {
        for name in format.names_beside(task.base_colour, &encode::name_of(output)) {
            let path = output.with_file_name(name);
            if let Some(input) = path.canonicalize().ok().and_then(|path| photos.get(&path)) {
                return Err(CliError::OverInput { input: input.to_path_buf(), path });
            }
        }
    }
    Ok(())
}

fn make_folder_of(output: &Path) -> Result<(), CliError> {
    let folder = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|reason| CliError::Unwritable { path: output.to_owned(), reason })
}
