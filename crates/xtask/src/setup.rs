//! Obtains everything a task needs, and only what is missing.

use crate::browser::{Browser, obtain_engines};
use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::readers::Readers;
use crate::toolchain::{Toolchain, require_component};
use crate::{networks, npm, paths, portrait, tools, workspace};
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// Where everything is, and the environment in which programs find it.
pub struct Kit {
    toolchain: Toolchain,
    programs: Vec<PathBuf>,
    browser: Option<Browser>,
    missing_engines: Vec<Failure>,
    readers: Readers,
}

/// What is needed to build and serve the page.
pub fn for_page() -> Result<Kit> {
    let kit = page_kit()?;
    tools::tidy_up()?;
    Ok(kit)
}

fn page_kit() -> Result<Kit> {
    let node_modules = npm::obtain()?;
    networks::obtain(&node_modules)?;
    portrait::obtain()?;
    let toolchain = Toolchain::obtain()?;
    let programs = vec![tools::wasm_bindgen()?.obtain()?, tools::trunk().obtain()?, npm::programs()];
    Ok(Kit { toolchain, programs, browser: None, missing_engines: Vec::new(), readers: Readers::default() })
}

/// What is needed to test it, too.
pub fn for_tests() -> Result<Kit> {
    require_component("rustfmt", &["fmt", "--version"])?;
    require_component("clippy", &["clippy", "--version"])?;
    let mut kit = page_kit()?;
    kit.programs.push(tools::wasm_pack().obtain()?);
    tools::tidy_up()?;
    kit.browser = Some(Browser::obtain()?);
    kit.missing_engines = obtain_engines();
    kit.readers = Readers::obtain();
    Ok(kit)
}

impl Kit {
    /// A program that builds for wasm32 or calls one that does: the wasm32 compiler and all tools are on its PATH.
    pub fn run(&self, program: impl AsRef<OsStr>) -> Result<Run> {
        let folders: Vec<PathBuf> = self.toolchain.path().into_iter().chain(self.programs.iter().cloned()).collect();
        let path = workspace::path_with(&folders)?;
        let found = find_in(&path, program.as_ref());
        let run = Run::new(found.as_deref().unwrap_or(Path::new(program.as_ref())));
        let browser = self.browser.iter().flat_map(Browser::variables).collect::<Vec<_>>();
        let run = run.without_env("CARGO").env("PATH", path).envs(&self.toolchain.variables()).envs(&browser);
        // Whatever is built for wasm32 is built with the same flags, or the tests would build the page's modules again.
        let (flags, value) = paths::remapped();
        let run = run.env(&flags, value);
        Ok(run.current_dir(workspace::root()))
    }

    /// The browser, where the tests need one.
    pub fn browser(&self) -> Option<&Browser> {
        self.browser.as_ref()
    }

    /// Why an engine beside Chromium is not there, for each that could not be had.
    pub fn missing_engines(&self) -> &[Failure] {
        &self.missing_engines
    }

    /// The programs that open our files.
    pub fn readers(&self) -> &Readers {
        &self.readers
    }
}

/// Looks a program up on the PATH it is going to have, which is not this program's own.
fn find_in(path: &OsString, program: &OsStr) -> Option<PathBuf> {
    let name = format!("{}{}", program.to_string_lossy(), std::env::consts::EXE_SUFFIX);
    std::env::split_paths(path).map(|folder| folder.join(&name)).find(|file| file.is_file())
}
