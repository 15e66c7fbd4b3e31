//! Steps of `cargo xtask test`: those of the gate, and with `--all` those of the night.
//!
//! Early steps run while tools compile. Later ones use the results of earlier ones: `dist` builds the types
//! for tsc and the page for the browsers.

mod gate;
mod night;

pub use gate::GATE;
pub use night::NIGHT;

use crate::need::Need;
use crate::places::root;
use crate::run::Run;
use crate::rust::command_line;
use crate::setup::Kit;
use anyhow::Result;
use fs_err as fs;

/// A step; it passes if its program exits with status 0.
pub struct Step {
    /// Name on the command line.
    pub name: &'static str,
    /// Description.
    pub what: &'static str,
    /// Needs in addition to Rust, Node.js and the packages of `package-lock.json`.
    pub needs: &'static [Need],
    /// Whether it runs while tools compile.
    pub is_early: bool,
    /// Prepares the program.
    pub program: Program,
}

type Program = fn(&Kit) -> Result<Run>;

const fn step(name: &'static str, what: &'static str, needs: &'static [Need], program: Program) -> Step {
    Step { name, what, needs, is_early: false, program }
}

/// A step that needs no tools, and passes while they compile.
const fn early(name: &'static str, what: &'static str, needs: &'static [Need], program: Program) -> Step {
    Step { name, what, needs, is_early: true, program }
}

impl Step {
    /// Whether `name` is this step's name, or the part of it before the colon.
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.name.split(':').next() == Some(name)
    }
}

fn cargo(words: &str) -> Run {
    Run::new("cargo").words(words)
}

fn with_command_line(run: Run) -> Result<Run> {
    Ok(run.env("ROSTO_CLI", command_line()?))
}

fn packages(run: Run, names: impl IntoIterator<Item = impl AsRef<str>>) -> Run {
    names.into_iter().fold(run, |run, name| run.args(["--package", name.as_ref()]))
}

const WORKER_MODULE: &str = "rosto-vision-web";
/// The page's module with the feature `webgl`. Built separately, because cargo would enable the feature for the others too.
const WEBGL_MODULE: &str = "rosto-studio-webgl";

/// Tests of a module with that module's features and profile, so that both builds share artefacts.
fn in_chromium(kit: &Kit) -> Run {
    let test = kit.run("wasm-pack").words("test --headless --chrome");
    let driver = std::env::var_os("CHROMEDRIVER");
    let test = driver.iter().fold(test, |test, driver| test.arg("--chromedriver").arg(driver));
    let test = test.arg(root().join("crates/viewport")).words("--locked --profile web");
    test.env("WASM_BINDGEN_TEST_TIMEOUT", "600")
}

/// Packages with browser tests, sorted.
fn tested_on_wasm() -> Result<Vec<String>> {
    let mut found = Vec::new();
    for folder in fs::read_dir(root().join("crates"))? {
        let folder = folder?;
        let manifest = fs::read_to_string(folder.path().join("Cargo.toml")).unwrap_or_default();
        if manifest.contains("wasm-bindgen-test") {
            found.push(format!("rosto-{}", folder.file_name().to_string_lossy()));
        }
    }
    found.sort();
    Ok(found)
}
