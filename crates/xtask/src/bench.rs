//! `cargo xtask bench`: measures Rosto and comparable software, and writes docs/benchmarks.json and the figures in the docs.

use crate::need;
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
/// Optional, because it needs a C library and a compiler.
const CHOLMOD: &str = "tests/bench/requirements-cholmod.txt";

/// Name, description, and a program that prints one JSON object per measurement.
type Part = (&'static str, &'static str, fn(&Kit) -> Result<Run>);
const PARTS: [Part; 4] = [
    ("native", "edits, photos, landmarks and textures", native),
    ("solvers", "edits in NumPy, SciPy, libigl and CHOLMOD", solvers),
    ("batches", "folders of photos in Python, compared with MediaPipe", batches),
    ("browser", "the page and comparable pages", browser),
];

/// Runs the named parts, or all, and replaces their results.
pub fn run(wanted: &[&str]) -> Result<()> {
    if let Some(unknown) = wanted.iter().find(|name| !PARTS.iter().any(|(part, ..)| part == *name)) {
        bail!("unknown part `{unknown}`: use native, solvers, batches or browser");
    }
    let kit = setup::obtain(&need::GATE)?;
    for (name, what, program) in PARTS.iter().filter(|(name, ..)| wanted.is_empty() || wanted.contains(name)) {
        announced(name, what, || {
            let lines = target().join("bench.jsonl");
            fs::write(&lines, program(&kit)?.within(LIMIT).checked()?)?;
            kit.run("node").arg("tests/bench/store.mjs").arg(lines).checked()
        })?;
    }
    kit.run("node").arg("docs/figures.mjs").checked()?;
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
    let python = python::environment(&[PEERS, CHOLMOD], "solvers for comparison");
    let python = python.or_else(|_| {
        println!("  · skipping CHOLMOD, which did not install (on Debian it needs libsuitesparse-dev)");
        python::environment(&[PEERS], "solvers for comparison")
    })?;
    Ok(Run::new(python).arg("tests/bench/peers.py"))
}

fn batches(_: &Kit) -> Result<Run> {
    let python = python::environment(&[python::MATURIN, MEDIAPIPE], "MediaPipe for comparison")?;
    python::install_package(&python, python::maturin(&python).arg("--release"))?;
    Ok(Run::new(python).arg("tests/bench/many.py").arg(assets().join("sample.png")))
}

fn browser(kit: &Kit) -> Result<Run> {
    page::build(kit)?;
    kit.run("node").arg("web/build/package.mjs").checked()?;
    let build = kit.run("cargo").words("build --locked --profile web --target").arg(WASM);
    build.words("--package rosto-vision-web --features bench --example networks").checked()?;
    let bind = kit.run("wasm-bindgen").words("--target web --no-typescript --out-dir").arg(root().join("target/bench"));
    bind.arg(target().join(WASM).join("web/examples/networks.wasm")).checked()?;
    Ok(kit.run("node").arg("tests/bench/browser.mjs"))
}
