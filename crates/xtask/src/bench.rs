//! `cargo xtask bench`: Rosto and its peers on this machine, into docs/benchmarks.json.

use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::python::Environment;
use crate::setup::{self, Kit};
use crate::toolchain::WASM;
use crate::{cache, dist, progress, wheel, workspace};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(7200);
const MEDIAPIPE: &str = "tests/reference/mediapipe_requirements.txt";
const PEERS: &str = "tests/bench/requirements.txt";
/// Needs a C library and a compiler: left out where it does not install.
const CHOLMOD: &str = "tests/bench/requirements-cholmod.txt";

/// A name, and a program that prints a JSON object per measurement.
type Part = (&'static str, fn(&Kit) -> Result<Run>);
const PARTS: [Part; 4] = [("native", native), ("solvers", solvers), ("batches", batches), ("browser", browser)];

/// Runs all parts, or those named; replaces the results of the tasks and peers that they measure.
pub fn run(wanted: &[&str]) -> Result<ExitCode> {
    if let Some(unknown) = wanted.iter().find(|name| !PARTS.iter().any(|(part, _)| part == *name)) {
        return Err(Failure::new(format!("unknown part `{unknown}`")).advice("use native, solvers, batches or browser"));
    }
    let kit = setup::for_tests()?;
    for (name, program) in PARTS.iter().filter(|(name, _)| wanted.is_empty() || wanted.contains(name)) {
        let started = Instant::now();
        let measured = program(&kit)?.current_dir(workspace::root()).within(LIMIT).run()?.checked()?;
        let lines = workspace::target().join("bench.jsonl");
        cache::write(&lines, measured)?;
        kit.run("node")?.arg(workspace::root().join("tests/bench/store.mjs")).arg(lines).run()?.checked()?;
        progress::done(name, started);
    }
    Ok(ExitCode::SUCCESS)
}

fn native(kit: &Kit) -> Result<Run> {
    let folder = workspace::target().join("criterion");
    cache::remove_folder(&folder)?;
    let crates = ["laplacian", "photo", "landmarks", "studio"].map(|name| format!("--package=rosto-{name}"));
    let bench = Run::new("cargo").current_dir(workspace::root()).args(["bench", "--locked", "--bench", "*"]);
    bench.args(crates).within(LIMIT).run()?.checked()?;
    Ok(kit.run("node")?.arg("tests/bench/criterion.mjs").arg(folder))
}

fn solvers(_: &Kit) -> Result<Run> {
    let environment = Environment::obtain(&[PEERS, CHOLMOD])?;
    environment.install(PEERS)?;
    if environment.install(CHOLMOD).is_err() {
        progress::note("CHOLMOD does not install here (on Debian it needs libsuitesparse-dev); it is left out");
    }
    Ok(Run::new(environment.python()).arg("tests/bench/peers.py"))
}

fn batches(_: &Kit) -> Result<Run> {
    let environment = Environment::obtain(&[MEDIAPIPE])?;
    environment.install(MEDIAPIPE)?;
    wheel::install_release(&environment.python())?;
    Ok(Run::new(environment.python()).arg("tests/bench/many.py").arg(workspace::assets().join("sample.png")))
}

fn browser(kit: &Kit) -> Result<Run> {
    dist::build(kit)?;
    let build = kit.run("cargo")?.args(["build", "--locked", "--profile", "web", "--target", WASM, "--package"]);
    let build = build.args(["rosto-vision-web", "--features", "bench", "--example", "networks"]);
    build.within(LIMIT).run()?.checked()?;
    let bind = kit.run("wasm-bindgen")?.args(["--target", "web", "--no-typescript", "--out-dir"]);
    let bind = bind.arg(workspace::root().join("target/bench"));
    bind.arg(workspace::target().join(WASM).join("web/examples/networks.wasm")).run()?.checked()?;
    kit.run("node").map(|node| node.arg("tests/bench/browser.mjs"))
}
