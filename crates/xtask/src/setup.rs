//! Installs the missing tools and files of a task.

use crate::places::{WASM, remapped, root};
use crate::run::{Run, causes, elapsed};
use crate::rust::{self, GECKODRIVER, TRUNK, Tool, WASM_BINDGEN, WASM_PACK};
use crate::{assets, python, system};
use anyhow::{Result, ensure};
use std::ffi::{OsStr, OsString};
use std::thread;
use std::time::Instant;

const READERS: &str = "tests/readers/requirements.txt";

/// Environment variables that point programs to the installed tools.
pub struct Kit {
    environment: Vec<(String, OsString)>,
    /// Errors of tools that could not be installed; tests that do not need them still run.
    missing: Vec<anyhow::Error>,
}

/// `cargo xtask setup`.
pub fn run(_: &[&str]) -> Result<()> {
    let started = Instant::now();
    let kit = for_tests()?;
    kit.report_missing();
    ensure!(kit.missing.is_empty(), "some tools could not be installed; see above");
    println!("Set-up is complete ({}).", elapsed(started.elapsed()));
    Ok(())
}

/// Tools to build and serve the page.
pub fn for_page() -> Result<Kit> {
    with_tools(&[&WASM_BINDGEN, &TRUNK])
}

fn with_tools(tools: &[&Tool]) -> Result<Kit> {
    assets::obtain()?;
    let debian = rust::for_wasm()?;
    let programs = tools.iter().map(|tool| tool.obtain()).collect::<Result<Vec<_>>>()?;
    rust::tidy_up()?;
    let folders = debian.iter().map(|sysroot| sysroot.join("bin")).chain(programs);
    let folders = folders.chain([root().join("node_modules/.bin")]);
    let present = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(folders.chain(std::env::split_paths(&present)))?;
    // The same flags for all wasm32 builds; otherwise the tests would rebuild the page's modules.
    let flags = format!("CARGO_TARGET_{}_RUSTFLAGS", WASM.to_uppercase().replace('-', "_"));
    let mut environment = vec![("PATH".to_owned(), path), (flags, remapped().into())];
    // rustup's proxy for cargo-clippy precedes the one on PATH, and accepts a folder here.
    environment.extend(debian.map(|sysroot| ("RUSTUP_TOOLCHAIN".to_owned(), sysroot.into())));
    Ok(Kit { environment, missing: Vec::new() })
}

/// Tools to build and test the page. Packages download while tools compile.
pub fn for_tests() -> Result<Kit> {
    thread::scope(|scope| {
        let system = scope.spawn(system::obtain);
        let readers = scope.spawn(|| python::environment(&[READERS], "62 MB: programs that open exported files"));
        rust::components()?;
        let mut kit = with_tools(&[&WASM_BINDGEN, &TRUNK, &WASM_PACK, &GECKODRIVER])?;
        kit.missing = system.join().expect("invariant: setting up does not panic");
        kit.environment.extend(system::chromium().map(|program| ("ROSTO_BROWSER".to_owned(), program.into())));
        match readers.join().expect("invariant: setting up does not panic") {
            Ok(python) => kit.environment.push(("ROSTO_READERS_PYTHON".to_owned(), python.into())),
            Err(missing) => kit.missing.push(missing),
        }
        Ok(kit)
    })
}

impl Kit {
    /// A program with the environment of the installed tools.
    pub fn run(&self, program: impl AsRef<OsStr>) -> Run {
        self.environment.iter().fold(Run::new(program), |run, (name, value)| run.env(name, value))
    }

    /// A script in `package.json`.
    pub fn npm(&self, script: &str) -> Run {
        self.run("npm").args(["run", "--silent", script])
    }

    /// Prints the errors of tools that could not be installed.
    pub fn report_missing(&self) {
        self.missing.iter().for_each(|missing| println!("✗ {}", causes(missing)));
    }
}
