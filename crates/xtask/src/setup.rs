//! Installs the missing tools and files of a task.

use crate::need::Need::{OldChromium, Page, Python, Readers, WasmPack};
use crate::need::{GATE, Need};
use crate::places::{WASM, remapped, root};
use crate::run::{Run, causes, elapsed};
use crate::rust::{self, TRUNK, Tool, WASM_BINDGEN, WASM_PACK};
use crate::{assets, python, system};
use anyhow::{Context, Result, ensure};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;
use std::thread;
use std::time::Instant;

const READERS: &str = "tests/readers/requirements.txt";
/// Separate, because it is several times as large as the other readers together, and needs Python 3.11.
const BLENDER: &str = "tests/readers/requirements-blender.txt";

/// Environment variables that point programs to the installed tools.
#[derive(Default)]
pub struct Kit {
    environment: Vec<(String, OsString)>,
    /// Errors of tools that could not be installed; tests that do not need them still run.
    missing: Vec<anyhow::Error>,
}

/// `cargo xtask setup`: the needs of the page, the gate and the pictures.
pub fn run(_: &[&str]) -> Result<()> {
    let started = Instant::now();
    let kit = obtain(&GATE)?;
    kit.report_missing();
    ensure!(kit.missing.is_empty(), "some tools could not be installed; see above");
    println!("Set-up is complete ({}).", elapsed(started.elapsed()));
    Ok(())
}

/// Installs missing tools and files. Packages download while tools compile.
pub fn obtain(needs: &[Need]) -> Result<Kit> {
    assets::node()?;
    thread::scope(|scope| {
        let files = scope.spawn(assets::obtain);
        let system = scope.spawn(|| system::obtain(needs));
        let python = scope.spawn(|| if needs.contains(&Python) { python::without_package().err() } else { None });
        let readers = scope.spawn(|| if needs.contains(&Readers) { readers() } else { Kit::default() });
        let mut kit = with_tools(needs)?;
        files.join().expect("invariant: setting up does not panic")?;
        kit.missing = system.join().expect("invariant: setting up does not panic");
        kit.missing.extend(python.join().expect("invariant: setting up does not panic"));
        kit.extend(readers.join().expect("invariant: setting up does not panic"));
        let chromium = system::chromium().map(|program| ("ROSTO_BROWSER", Ok(program)));
        let oldest = needs.contains(&OldChromium).then(|| ("ROSTO_OLDEST_BROWSER", system::oldest_chromium()));
        kit.point_to([chromium, oldest].into_iter().flatten());
        Ok(kit)
    })
}

/// Tools that cargo compiles, and the environment in which they run.
fn with_tools(needs: &[Need]) -> Result<Kit> {
    let page: &[&Tool] = if needs.contains(&Page) { &[&WASM_BINDGEN, &TRUNK] } else { &[] };
    let tests: &[&Tool] = if needs.contains(&WasmPack) { &[&WASM_PACK] } else { &[] };
    let debian = if needs.contains(&Page) { rust::for_wasm()? } else { None };
    let programs = page.iter().chain(tests).map(|tool| tool.obtain()).collect::<Result<Vec<_>>>()?;
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

fn readers() -> Kit {
    let mut kit = Kit::default();
    kit.point_to([
        ("ROSTO_READERS_PYTHON", python::environment(&[READERS], "62 MB: programs that open exported files")),
        ("ROSTO_READERS_BLENDER", python::environment(&[BLENDER], "373 MB: Blender; needs Python 3.11")),
    ]);
    kit
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

    /// Value of a variable that points to an installed program.
    pub fn program(&self, name: &str) -> Result<&OsStr> {
        let found = self.environment.iter().find(|(variable, _)| variable == name);
        found.map(|(_, value)| value.as_os_str()).with_context(|| format!("{name} is not set"))
    }

    /// Prints the errors of tools that could not be installed.
    pub fn report_missing(&self) {
        self.missing.iter().for_each(|missing| println!("✗ {}", causes(missing)));
    }

    fn point_to(&mut self, programs: impl IntoIterator<Item = (&'static str, Result<PathBuf>)>) {
        for (name, program) in programs {
            match program {
                Ok(program) => self.environment.push((name.to_owned(), program.into())),
                Err(missing) => self.missing.push(missing),
            }
        }
    }

    fn extend(&mut self, other: Self) {
        self.environment.extend(other.environment);
        self.missing.extend(other.missing);
    }
}
