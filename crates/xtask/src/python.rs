//! Python environments in the user's cache, and the Python package in them.

use crate::assets;
use crate::places::{self, cache, remove_folder, root, sha256, target};
use crate::run::{Run, announced};
use crate::rust::compiled_by_clippy;
use crate::system::with_pip;
use anyhow::{Context, Result};
use fs_err as fs;
use std::path::{Path, PathBuf};

/// Build tools of the package.
pub const MATURIN: &str = "crates/python/requirements-build.txt";
const TESTS: &str = "tests/python/requirements.txt";
const CLUSTERS: &str = "tests/python/night/requirements.txt";

/// Returns the interpreter of an environment with the packages that `requirements` pin. Other pins give another
/// environment.
pub fn environment(requirements: &[&str], why: &str) -> Result<PathBuf> {
    let pins = requirements.iter().map(|file| fs::read_to_string(root().join(file)));
    let folder = cache()?.join("python").join(&sha256(pins.collect::<Result<String, _>>()?.as_bytes())[..16]);
    let python = folder.join("bin/python");
    let complete = folder.join("complete");
    if complete.is_file() {
        return Ok(python);
    }
    announced(&format!("Python packages in {}", requirements.join(" and ")), why, || {
        with_pip()?;
        remove_folder(&folder)?;
        Run::new("python3").words("-m venv").arg(&folder).checked()?;
        for file in requirements {
            pip(&python).words("install --quiet -r").arg(file).checked()?;
        }
        Ok(fs::write(complete, "")?)
    })?;
    Ok(python)
}

/// Returns an interpreter with what the package's tests import.
pub fn without_package() -> Result<PathBuf> {
    environment(&[MATURIN, TESTS], "60 MB: pandas, pyarrow and mypy for the tests")
}

/// Like [`without_package`], with the package, built from the artefacts of the native tests.
pub fn for_tests() -> Result<PathBuf> {
    with_package(without_package()?)
}

/// Like [`for_tests`], with clusters and notebooks.
pub fn for_clusters() -> Result<PathBuf> {
    with_package(environment(&[MATURIN, TESTS, CLUSTERS], "300 MB: Ray, Dask and Jupyter for the tests")?)
}

fn with_package(python: PathBuf) -> Result<PathBuf> {
    install_package(&python, compiled_by_clippy(maturin(&python)).words("--profile dev --compatibility linux"))?;
    Ok(python)
}

/// pytest; takes folders as arguments.
pub fn pytest(python: &Path) -> Run {
    Run::new(python).words("-m pytest --quiet --disable-warnings --durations=5 -p no:cacheprovider")
}

/// maturin's command that builds the package; takes options.
pub fn maturin(python: &Path) -> Run {
    Run::new(python).words("-m maturin build --locked --manifest-path crates/python/Cargo.toml").log("maturin")
}

/// Builds the package with maturin, and installs it without its dependencies.
pub fn install_package(python: &Path, maturin: Run) -> Result<()> {
    let wheel = build(maturin, "python/wheels")?;
    pip(python).words("install --quiet --no-deps --force-reinstall").arg(wheel).checked().map(|_| ())
}

/// `cargo xtask wheel`: builds the wheel in `target/wheels`, and finds a face with it in an empty environment.
pub fn wheel(_: &[&str]) -> Result<()> {
    assets::obtain()?;
    let maturin = maturin(&environment(&[MATURIN], "builds the Python package")?).arg("--release");
    let wheel = announced("wheel", "the first build takes several minutes", || build(maturin, "wheels"))?;
    let empty = target().join("python/empty");
    let python = empty.join("bin/python");
    Run::new("python3").words("-m venv --clear").arg(&empty).checked()?;
    pip(&python).arg("install").arg(&wheel).checked()?;
    let find = "import rosto, sys; print('landmarks of the portrait:', rosto.landmarks(sys.argv[1:]).points.shape)";
    print!("{}", Run::new(&python).args(["-c", find]).arg(places::assets().join("sample.png")).checked()?);
    println!("{} is ready.", wheel.display());
    Ok(())
}

/// Builds a wheel into an emptied folder of `target`, and returns its path.
fn build(maturin: Run, folder: &str) -> Result<PathBuf> {
    let folder = target().join(folder);
    remove_folder(&folder)?;
    maturin.arg("--out").arg(&folder).checked()?;
    Ok(fs::read_dir(&folder)?.next().context("maturin did not build a wheel")??.path())
}

fn pip(python: &Path) -> Run {
    Run::new(python).words("-m pip --disable-pip-version-check").log("pip")
}
