use std::path::Path;
use std::time::Instant;
use std::{fs, io};

use glam::DVec3;
use rosto_export::{GlbOptions, Model, Paint, glb};
use rosto_face::{FaceModel, Triangulation};

use crate::args::PaperTask;
use crate::encode::model_from_image;
use crate::error::CliError;
use crate::{files, networks, portrait};

mod experiment;
mod plot;
mod report;
mod statistics;

use experiment::{Method, Trial};

/// `rosto paper`: the paper's experiment on this photo and this machine, over many seeds and every way of editing.
pub fn run(task: &PaperTask, networks: Option<&Path>) -> Result<(), CliError> {
    let photo = portrait::open(&task.photo)?;
    let finder = networks::load(networks)?;
    let started = Instant::now();
    let face = portrait::face(&photo, &task.photo, &finder)?;
    let extraction = started.elapsed();
    let started = Instant::now();
    let face = portrait::model(&photo, &face, Triangulation::Tessellation, &task.photo)?;
    let generation = started.elapsed();
    let trials = trials(&face, task)?;
    let paper = &trials[0].1;
    write_figures(&face, &paper[0], &task.output)?;
    let plot = plot::svg(paper);
    files::write(&task.output.join("times.svg"), plot.as_bytes())?;
    files::print(&report::markdown(extraction, generation, &trials, &task.output))
}

/// For each method, a trial for each seed; the paper's method first.
fn trials(face: &FaceModel, task: &PaperTask) -> Result<Vec<(Method, Vec<Trial>)>, CliError> {
    let seeds = (0..task.runs.max(1)).map(|run| task.seed.wrapping_add(run));
    let of_method = |method: Method| {
        let trials = seeds.clone().map(|seed| experiment::trial(face, method, seed)).collect::<Result<_, _>>();
        trials.map(|trials| (method, trials)).map_err(|reason| CliError::Studio(reason.into()))
    };
    Method::all().into_iter().map(of_method).collect()
}

/// The meshes of Figures 3, 4 and 5: before the edits, after the small ones, after the large ones.
fn write_figures(face: &FaceModel, trial: &Trial, folder: &Path) -> Result<(), CliError> {
    let unwritable = |reason: io::Error| CliError::Unwritable { path: folder.to_owned(), reason };
    fs::create_dir_all(folder).map_err(unwritable)?;
    let [after_small, after_large] = &trial.after_rounds;
    let figures: [(&str, &[DVec3]); 3] =
        [("figure-3", face.positions_image()), ("figure-4", after_small), ("figure-5", after_large)];
    for (name, positions) in figures {
        let positions_m = model_from_image(face, positions);
        let options = GlbOptions { paint: Paint::VertexColours, name, ..GlbOptions::default() };
        files::write(
            &folder.join(name).with_extension("glb"),
            &glb(&Model::of_face(face).at(&positions_m), &options)?,
        )?;
    }
    Ok(())
}
