use std::path::Path;
use std::time::{Duration, Instant};
use std::{fs, io};

use glam::DVec3;
use rosto::landmarks_m_from_image;
use rosto_export::{BaseColour, GlbOptions, Model, glb};
use rosto_face::{FaceModel, Observation, PhotoLens, Triangulation};
use rosto_laplacian::LaplacianError;
use rosto_studio::paper::{Experiment, Method, MethodOutcome, Plan, PlotWords, Trial, svg};

use crate::args::PaperTask;
use crate::error::CliError;
use crate::{faces, files, networks, output, terminal};

mod report;

/// Number of timings per edit; the median counts.
const REPETITIONS: usize = 5;

const FIGURES: [&str; 3] = ["figure-3.glb", "figure-4.glb", "figure-5.glb"];
const PLOT: &str = "times.svg";

/// First line of the plot, by which a later run recognises its own file.
const PLOT_START: &str = "<!-- Rosto -->";

const PLOT_PX: [f64; 2] = [640.0, 400.0];

/// Runs `rosto paper`: the paper's experiment on this photo and machine, over many seeds and with each operator and
/// constraint.
pub fn run(task: &PaperTask, networks: Option<&Path>) -> Result<(), CliError> {
    check_output(task)?;
    let photo = faces::open(&task.photo)?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let started = Instant::now();
    let (landmarks, notes) = faces::first(&photo, &task.photo, &finder, &task.find)?;
    let extraction = started.elapsed();
    notes.iter().for_each(|note| terminal::note(note));
    let started = Instant::now();
    let observation = Observation::without_picture(&photo, landmarks).with_lens(PhotoLens::Estimated);
    let face = FaceModel::new(observation, Triangulation::Tessellation)
        .map_err(|reason| CliError::NoModel { path: task.photo.clone(), reason })?;
    let generation = started.elapsed();
    let unsolved = |reason: LaplacianError| CliError::Request(rosto::Error::Studio(reason.into()));
    let experiment = Experiment::new(face.topology().clone(), face.positions_image().to_vec()).map_err(unsolved)?;
    let of_method = |method| Ok((method, trials(&experiment, method, task)?));
    let all: Vec<(Method, Vec<Trial>)> =
        Method::all().into_iter().map(of_method).collect::<Result<_, _>>().map_err(unsolved)?;
    let outcomes: Vec<MethodOutcome> =
        all.iter().map(|(method, trials)| MethodOutcome::of(&experiment, *method, trials)).collect();
    let paper = &all[0].1;
    write_figures(&face, &paper[0], &task.output)?;
    let plot = format!("{PLOT_START}\n{}", svg(paper, PLOT_PX, &plot_words()));
    output::write(&task.output.join(PLOT), plot.as_bytes())?;
    files::print(&report::markdown(extraction, generation, paper, &outcomes, &task.output))
}

/// Refuses, before any work is done, an output that is not a folder, or files in it that are the photo or not Rosto's.
fn check_output(task: &PaperTask) -> Result<(), CliError> {
    match fs::metadata(&task.output) {
        Ok(there) if there.is_dir() => {
            let mut names = FIGURES.into_iter().chain([PLOT]);
            names.try_for_each(|name| check_file(task, &task.output.join(name)))
        }
        Ok(_) => {
            let reason = io::ErrorKind::NotADirectory.into();
            Err(CliError::Unwritable { path: task.output.clone(), reason })
        }
        Err(_) => Ok(()),
    }
}

fn check_file(task: &PaperTask, path: &Path) -> Result<(), CliError> {
    output::check(path, &[&task.photo])?;
    match fs::read(path) {
        Ok(found) if !task.force && !is_ours(&found) => {
            Err(CliError::Foreign { path: path.to_owned(), for_file: task.photo.clone() })
        }
        _ => Ok(()),
    }
}

/// Whether Rosto wrote the GLB or plot.
fn is_ours(found: &[u8]) -> bool {
    let generator = b"\"generator\":\"Rosto ";
    found.starts_with(PLOT_START.as_bytes()) || found.windows(generator.len()).any(|bytes| bytes == generator)
}

fn plot_words() -> PlotWords {
    let [title, degree, small, large] =
        ["Time per edit without a stored factor (ms)", "degree", "small offset", "large offset"].map(str::to_owned);
    PlotWords { title, degree, small, large }
}

/// Runs one trial per seed.
fn trials(experiment: &Experiment, method: Method, task: &PaperTask) -> Result<Vec<Trial>, LaplacianError> {
    let seeds = (0..task.runs).map(|run| task.seed.wrapping_add(run));
    seeds.map(|seed| trial(experiment, method, seed)).collect()
}

fn trial(experiment: &Experiment, method: Method, seed: u64) -> Result<Trial, LaplacianError> {
    let mut trial = Trial::new(experiment, method, seed);
    while let Some(plan) = trial.next_edit(experiment) {
        let (edited, time) = timed(&trial, experiment, &plan)?;
        trial.go_on(experiment, plan, edited, time);
    }
    Ok(trial)
}

/// The result of an edit and its median time.
fn timed(trial: &Trial, experiment: &Experiment, plan: &Plan) -> Result<(Vec<DVec3>, Duration), LaplacianError> {
    let mut times = Vec::new();
    loop {
        let started = Instant::now();
        let edited = trial.edit(experiment, plan)?;
        times.push(started.elapsed());
        if times.len() == REPETITIONS {
            times.sort_unstable();
            return Ok((edited, times[REPETITIONS / 2]));
        }
    }
}

/// Writes the meshes of Figures 3, 4 and 5: unedited, after the small edits, after the large edits.
fn write_figures(face: &FaceModel, trial: &Trial, folder: &Path) -> Result<(), CliError> {
    let unwritable = |reason: io::Error| CliError::Unwritable { path: folder.to_owned(), reason };
    fs::create_dir_all(folder).map_err(unwritable)?;
    let rounds = trial.after_rounds().iter().map(Vec::as_slice);
    let figures = FIGURES.into_iter().zip([face.positions_image()].into_iter().chain(rounds));
    for (file, positions) in figures {
        let positions_m = landmarks_m_from_image(face, positions);
        let name = file.trim_end_matches(".glb");
        let options = GlbOptions { base_colour: BaseColour::VertexColours, name, ..GlbOptions::default() };
        output::write(
            &folder.join(file),
            &glb(&Model::of_face(face).at(&positions_m), &options).map_err(rosto::Error::from)?,
        )?;
    }
    Ok(())
}
