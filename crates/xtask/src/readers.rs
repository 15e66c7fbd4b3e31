//! The programs that are not ours and open our files, and `cargo xtask readers`, which includes Blender.

use crate::failure::{Failure, Result};
use crate::process::{Run, find_program};
use crate::python::Environment;
use crate::{apt, progress, setup, test, versions};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

const REQUIREMENTS: &str = "tests/readers/requirements.txt";
/// Several times as large as all the others together: not for every run of the tests.
const BLENDER: &str = "tests/readers/requirements-blender.txt";
const SLICER: &str = "prusa-slicer";
const LIMIT: Duration = Duration::from_secs(3600);

/// The readers beside those that run in the browser, which npm brings along.
#[derive(Default)]
pub struct Readers {
    python: Option<PathBuf>,
    missing: Vec<Failure>,
}

impl Readers {
    /// Installs those that are missing, and says which of them could not be had: the others read all the same.
    pub fn obtain() -> Self {
        let (python, mut missing) = match python_readers() {
            Ok((python, missing)) => (Some(python), missing),
            Err(failure) => (None, vec![failure]),
        };
        missing.extend(slicer().err());
        missing.iter().for_each(|failure| progress::note(&failure.to_string()));
        Self { python, missing }
    }

    /// Why a reader is not there, for each that could not be had.
    pub fn missing(&self) -> &[Failure] {
        &self.missing
    }

    /// Runs them over every file that the command line's `program` writes; `npm` is the program that starts them.
    pub fn over_all_files(&self, npm: Run, program: PathBuf) -> Run {
        let run = npm.args(["run", "--silent", "readers"]).env("ROSTO_CLI", program);
        self.python.iter().fold(run, |run, python| run.env("ROSTO_READERS_PYTHON", python))
    }
}

/// Opens every file with every reader, Blender included.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_tests()?;
    let blender = blender()?;
    progress::announce("readers", "every file in programs that are not ours");
    let run = kit.readers().over_all_files(kit.run("npm")?, test::command_line()?);
    let ended = run.env("ROSTO_READERS_BLENDER", blender).within(LIMIT).run()?;
    println!("{}", ended.output);
    Ok(if ended.success { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The interpreter with the readers in Python, and why for each that does not install.
fn python_readers() -> Result<(PathBuf, Vec<Failure>)> {
    let environment = Environment::obtain(&[REQUIREMENTS])?;
    if environment.has(REQUIREMENTS) {
        return Ok((environment.python(), Vec::new()));
    }
    progress::announce("readers in Python, 62 MB", "trimesh, pygltflib, OpenUSD and lib3mf open every file in a test");
    let started = Instant::now();
    let missing = match environment.install(REQUIREMENTS) {
        Ok(()) => Vec::new(),
        Err(_) => environment.install_each(REQUIREMENTS)?,
    };
    progress::done("readers in Python", started);
    Ok((environment.python(), missing))
}

fn slicer() -> Result {
    if find_program(SLICER).is_some() {
        return Ok(());
    }
    progress::announce("PrusaSlicer, 92 MB", "it slices the closed bodies in a test");
    let started = Instant::now();
    apt::install(&versions::DEBIAN_SLICER)
        .map_err(|cause| Failure::new("PrusaSlicer cannot be had, so nothing is sliced").because(&cause))?;
    progress::done("PrusaSlicer", started);
    Ok(())
}

/// The interpreter with Blender as a module.
fn blender() -> Result<PathBuf> {
    let environment = Environment::obtain(&[BLENDER])?;
    if !environment.has(BLENDER) {
        progress::announce("Blender, 373 MB", "it opens every file, and is too large for every run of the tests");
        let started = Instant::now();
        environment.install(BLENDER).map_err(|cause| {
            let failure = Failure::new("Blender does not install for this Python").because(&cause);
            failure.advice("use the version of Python that its package is for: 3.11")
        })?;
        progress::done("Blender", started);
    }
    Ok(environment.python())
}
