//! `cargo xtask bench`: Rosto and its peers on this machine, into docs/benchmarks.json.

use crate::places::{WASM, assets, remove_folder, root, target};
use crate::run::{Run, announced};
use crate::setup::{self, Kit};
use crate::{page, python};
use anyhow::{Result, bail};
use fs_err as fs;
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(7200);
const MEDIAPIPE: &str = "tests/reference/mediapipe_requirements.txt";
const PEERS: &str = "tests/bench/requirements.txt";
/// Needs a C library and a compiler: left out where it does not install.
const CHOLMOD: &str = "tests/bench/requirements-cholmod.txt";

/// A name, what is measured, and a program that prints a JSON object per measurement.
type Part = (&'static str, &'static str, fn(&Kit) -> Result<Run>);
const PARTS: [Part; 4] = [
    ("native", "edits, photos, landmarks and textures on this machine", native),
    ("solvers", "edits in NumPy, SciPy, libigl and CHOLMOD", solvers),
    ("batches", "many photos in Python, compared with MediaPipe's package", batches),
    ("browser", "the page and its peers in fresh browsers", browser),
];

/// Runs all parts, or those named; replaces the results of the tasks and peers that they measure.
pub fn run(wanted: &[&str]) -> Result<()> {
    if let Some(unknown) = wanted.iter().find(|name| !PARTS.iter().any(|(part, ..)| part == *name)) {
        bail!("unknown part `{unknown}`: use native, solvers, batches or browser");
    }
    let kit = setup::for_tests()?;
    for (name, what, program) in PARTS.iter().filter(|(name, ..)| wanted.is_empty() || wanted.contains(name)) {
        announced(name, what, || {
            let lines = target().join("bench.jsonl");
            fs::write(&lines, program(&kit)?.within(LIMIT).checked()?)?;
            kit.run("node").arg("tests/bench/store.mjs").arg(lines).checked()
        })?;
    }
    Ok(())
}

fn native(kit: &Kit) -> Result<Run> {
    let folder = target().join("criterion");
    remove_folder(&folder)?;
    let crates = ["laplacian", "photo", "landmarks", "studio"].map(|name| format!("--package=rosto-{name}"));
    Run::new("cargo").words("bench --locked --bench *").args(crates).checked()?;
    Ok(kit.run("node").arg("tests/bench/criterion.mjs").arg(folder))
}

fn solvers(_: &Kit) -> Result<Run> {
    let python = python::environment(&[PEERS, CHOLMOD], "the solvers that edits are compared with");
    let python = python.or_else(|_| {
        println!("  · CHOLMOD does not install here (on Debian it needs libsuitesparse-dev); it is left out");
        python::environment(&[PEERS], "the solvers that edits are compared with")
    })?;
    Ok(Run::new(python).arg("tests/bench/peers.py"))
}

fn batches(_: &Kit) -> Result<Run> {
    let python = python::environment(&[python::MATURIN, MEDIAPIPE], "photos are measured with MediaPipe, too")?;
    python::install_package(&python, "--release")?;
    Ok(Run::new(python).arg("tests/bench/many.py").arg(assets().join("sample.png")))
}

fn browser(kit: &Kit) -> Result<Run> {
    page::build(kit)?;
    let build = kit.run("cargo").words("build --locked --profile web --target").arg(WASM);
    build.words("--package rosto-vision-web --features bench --example networks").checked()?;
    let bind = kit.run("wasm-bindgen").words("--target web --no-typescript --out-dir").arg(root().join("target/bench"));
    bind.arg(target().join(WASM).join("web/examples/networks.wasm")).checked()?;
    Ok(kit.run("node").arg("tests/bench/browser.mjs"))
}
