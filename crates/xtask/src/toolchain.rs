//! A compiler that can build for wasm32: the present one with rustup's target, or Debian's with a library built here.

use crate::failure::{Failure, Result};
use crate::process::{Run, find_program};
use crate::{debian, progress, workspace};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The target of the page's modules.
pub const WASM: &str = "wasm32-unknown-unknown";

/// rustup is given up when nothing has arrived for so long: without a route it hangs rather than fails.
const RUSTUP_STALL: Duration = Duration::from_secs(45);
const RUSTUP_LIMIT: Duration = Duration::from_secs(900);

/// Which compiler builds for wasm32.
#[derive(Clone, Debug)]
pub enum Toolchain {
    /// The one that runs this program.
    Present,
    /// Debian's, seen through a folder of this user's cache that adds the wasm32 library.
    Debian(PathBuf),
}

impl Toolchain {
    /// Finds or obtains it.
    pub fn obtain() -> Result<Self> {
        if has_target(&present_sysroot()?) {
            return Ok(Self::Present);
        }
        if let Some(folder) = debian::already_built()? {
            return Ok(Self::Debian(folder));
        }
        progress::announce("Rust's library for wasm32", "the page is compiled to WebAssembly");
        let started = Instant::now();
        let toolchain = Self::from_rustup().or_else(|rustup| {
            progress::note("rustup could not add it; building it from Debian's sources");
            debian::build().map(Self::Debian).map_err(|debian| {
                Failure::new("no compiler for wasm32-unknown-unknown could be had")
                    .because(&rustup)
                    .because(&debian)
                    .advice("add the target yourself: rustup target add wasm32-unknown-unknown")
                    .advice("or, on Debian 12 or later, make apt-get work (as root or with sudo) and try again")
            })
        })?;
        progress::done("wasm32 library", started);
        Ok(toolchain)
    }

    /// Folder to put in front of PATH.
    pub fn path(&self) -> Option<PathBuf> {
        match self {
            Self::Present => None,
            Self::Debian(folder) => Some(folder.join("bin")),
        }
    }

    /// What the environment of cargo, Trunk and wasm-pack needs to use it.
    pub fn variables(&self) -> Vec<(String, OsString)> {
        match self {
            Self::Present => Vec::new(),
            // rustup's stand-ins for cargo and rustc take a folder here; others find the compiler on PATH.
            Self::Debian(folder) => vec![("RUSTUP_TOOLCHAIN".to_owned(), folder.clone().into_os_string())],
        }
    }

    fn from_rustup() -> Result<Self> {
        if find_program("rustup").is_none() {
            return Err(Failure::new("this machine has no rustup"));
        }
        let home = Run::new("rustup").args(["show", "home"]).quietly()?.checked()?;
        let downloads = Path::new(home.trim()).join("downloads");
        let add = Run::new("rustup").args(["target", "add", WASM]).current_dir(workspace::root());
        add.within(RUSTUP_LIMIT).unless_stalled(RUSTUP_STALL, downloads).run()?.checked()?;
        if has_target(&present_sysroot()?) {
            return Ok(Self::Present);
        }
        Err(Failure::new("rustup added the target, but not to the compiler that cargo uses"))
    }
}

/// Adds a component (rustfmt, clippy) to the present toolchain where `probe` says that it is missing.
pub fn require_component(component: &str, probe: &[&str]) -> Result {
    let works =
        || Run::new("cargo").args(probe).current_dir(workspace::root()).quietly().is_ok_and(|ended| ended.success);
    if works() {
        return Ok(());
    }
    progress::announce(component, "the tests check the sources with it");
    let missing = || Failure::new(format!("Rust's component {component} is missing"));
    let by_hand = format!("add it yourself: rustup component add {component}");
    if find_program("rustup").is_none() {
        return Err(missing().tried("this machine has no rustup").advice("install it with your Rust"));
    }
    let add = Run::new("rustup").args(["component", "add", component]).current_dir(workspace::root());
    let added = add.within(RUSTUP_STALL * 4).run()?.checked();
    added.map(|_| ()).map_err(|cause| missing().because(&cause).advice(by_hand))
}

/// Whether this sysroot has a standard library for wasm32.
pub fn has_target(sysroot: &Path) -> bool {
    let libraries = sysroot.join("lib/rustlib").join(WASM).join("lib");
    let Ok(entries) = std::fs::read_dir(libraries) else { return false };
    entries.flatten().any(|entry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        name.starts_with("libstd-") && name.ends_with(".rlib")
    })
}

fn present_sysroot() -> Result<PathBuf> {
    let printed = Run::new("rustc").args(["--print", "sysroot"]).current_dir(workspace::root()).quietly()?.checked()?;
    Ok(PathBuf::from(printed.trim()))
}
