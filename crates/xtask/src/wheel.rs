//! `cargo xtask wheel`: the Python package as a wheel, and the interpreter that tests it.

use crate::failure::{Doing, Failure, Result};
use crate::process::Run;
use crate::python::Environment;
use crate::{cache, networks, npm, progress, workspace};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const PACKAGE: &str = "crates/python";
const MATURIN: &str = "crates/python/requirements-build.txt";
/// What the tests of the package import.
const REQUIREMENTS: &str = "tests/python/requirements.txt";
/// What the package has of the project's own: its licences, and below that folder its networks.
const LICENCES: [&str; 3] = ["LICENSE-MIT", "LICENSE-APACHE", "NOTICE"];
const NETWORKS: &str = "rosto/networks";
const LIMIT: Duration = Duration::from_secs(3600);

/// How the native part is compiled.
#[derive(Clone, Copy)]
enum Profile {
    /// As it is published.
    Release,
    /// As the native tests build all it is made of.
    Tests,
}

impl Profile {
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Release => &["--release"],
            // Which systems it would run on, nobody asks of it.
            Self::Tests => &["--profile", "dev", "--compatibility", "linux"],
        }
    }

    fn folder(self) -> PathBuf {
        workspace::target().join(match self {
            Self::Release => "wheels",
            Self::Tests => "python/wheels",
        })
    }
}

/// Builds the wheel into `target/wheels`, installs it where nothing else is, and finds a face with it.
pub fn run() -> Result<ExitCode> {
    networks::obtain(&npm::obtain()?)?;
    println!("Building the wheel; the first time takes some minutes.");
    let started = Instant::now();
    let wheel = build(Profile::Release)?;
    let empty = workspace::target().join("python").join("empty");
    cache::remove_folder(&empty)?;
    Run::new("python3").args(["-m", "venv"]).arg(&empty).within(LIMIT).run()?.checked()?;
    let python = empty.join("bin").join("python");
    println!("{}", install(&python, &wheel, &[])?.trim());
    let shape =
        "import rosto, sys; print('landmarks of the sample portrait:', rosto.landmarks(sys.argv[1:]).points.shape)";
    let sample = workspace::assets().join("sample.png");
    println!("{}", Run::new(&python).args(["-c", shape]).arg(&sample).within(LIMIT).run()?.checked()?.trim());
    println!("{} is ready ({}).", wheel.display(), progress::elapsed(started.elapsed()));
    Ok(ExitCode::SUCCESS)
}

/// An interpreter with the package as it is now, and with all that its tests need.
pub fn for_tests() -> Result<PathBuf> {
    let environment = Environment::obtain(&[REQUIREMENTS])?;
    if !environment.has(REQUIREMENTS) {
        progress::announce(
            "Python packages, 300 MB",
            "Ray, Dask, Arrow and a notebook use the Python package in a test",
        );
        let started = Instant::now();
        environment.install(REQUIREMENTS)?;
        progress::done("Python packages", started);
    }
    let wheel = build(Profile::Tests)?;
    install(&environment.python(), &wheel, &["--no-deps", "--force-reinstall", "--quiet"])?;
    Ok(environment.python())
}

/// The package as it is published, for an interpreter whose environment has all else that it needs.
pub fn install_release(python: &Path) -> Result {
    install(python, &build(Profile::Release)?, &["--no-deps", "--force-reinstall", "--quiet"]).map(|_| ())
}

fn build(profile: Profile) -> Result<PathBuf> {
    let package = workspace::root().join(PACKAGE);
    for licence in LICENCES {
        cache::copy(&workspace::root().join(licence), &package.join(licence))?;
    }
    for network in networks::FILES {
        cache::copy(&workspace::assets().join(network), &package.join(NETWORKS).join(network))?;
    }
    let environment = Environment::obtain(&[MATURIN])?;
    environment.install(MATURIN)?;
    let folder = profile.folder();
    cache::remove_folder(&folder)?;
    let maturin = Run::new(environment.python()).args(["-m", "maturin", "build", "--locked", "--out"]).arg(&folder);
    let maturin = maturin.arg("--manifest-path").arg(package.join("Cargo.toml")).args(profile.arguments());
    maturin.current_dir(workspace::root()).within(LIMIT).run()?.checked()?;
    only_file_in(&folder)
}

fn only_file_in(folder: &Path) -> Result<PathBuf> {
    let entries = std::fs::read_dir(folder).doing(format!("listing {}", folder.display()))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    match (files.pop(), files.is_empty()) {
        (Some(file), true) => Ok(file),
        _ => Err(Failure::new(format!("{} should hold one wheel", folder.display()))),
    }
}

fn install(python: &Path, wheel: &Path, options: &[&str]) -> Result<String> {
    let pip = Run::new(python).args(["-m", "pip", "install", "--disable-pip-version-check"]);
    pip.args(options).arg(wheel).within(LIMIT).run()?.checked()
}
