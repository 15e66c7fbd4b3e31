//! The programs that build, test and check, each installed with cargo into the user's cache.

use crate::failure::{Failure, Result};
use crate::process::{Run, find_program};
use crate::{cache, progress, versions, workspace};
use std::path::PathBuf;
use std::time::{Duration, Instant};

const BUILD_LIMIT: Duration = Duration::from_secs(3600);

/// A program that comes from a crate.
pub struct Tool {
    package: &'static str,
    version: String,
    program: &'static str,
    features: Features,
    speed: Speed,
    why: &'static str,
}

/// How fast the program itself has to be.
enum Speed {
    /// It waits for compilers and browsers: compiled as quickly as can be.
    Waits,
    /// It works through megabytes: a little optimised.
    Works,
}

/// Which of a crate's features are compiled.
enum Features {
    Default,
    Only(&'static str),
}

/// Builds the page.
pub fn trunk() -> Tool {
    let why = "it builds and serves the page";
    // It must be built with one kind of TLS, though all it calls is on PATH already; it need not look for updates.
    let features = Features::Only("rustls");
    Tool { features, speed: Speed::Waits, ..Tool::new("trunk", versions::TRUNK, why) }
}

/// Writes the JavaScript side of the wasm modules; must be the version of the crate in `Cargo.lock`.
pub fn wasm_bindgen() -> Result<Tool> {
    let version = workspace::locked_version("wasm-bindgen")?;
    let why = "it joins the WebAssembly modules to JavaScript";
    Ok(Tool { program: "wasm-bindgen", ..Tool::new("wasm-bindgen-cli", &version, why) })
}

/// Runs the wasm tests.
pub fn wasm_pack() -> Tool {
    let why = "it runs the WebAssembly tests in a browser";
    Tool { speed: Speed::Waits, ..Tool::new("wasm-pack", versions::WASM_PACK, why) }
}

/// Checks what the workspace depends on.
pub fn cargo_deny() -> Tool {
    let why = "it checks licences, bans and sources of what is compiled";
    Tool::new("cargo-deny", versions::CARGO_DENY, why)
}

/// Tells what a change of a library asks of its users.
pub fn cargo_semver_checks() -> Tool {
    let why = "it compares the published crates with their last release";
    Tool::new("cargo-semver-checks", versions::CARGO_SEMVER_CHECKS, why)
}

/// Runs the fuzz targets.
pub fn cargo_fuzz() -> Tool {
    let why = "it fuzzes the readers";
    Tool { speed: Speed::Waits, ..Tool::new("cargo-fuzz", versions::CARGO_FUZZ, why) }
}

impl Tool {
    /// A program that is called as its crate is.
    fn new(package: &'static str, version: &str, why: &'static str) -> Self {
        let (features, speed) = (Features::Default, Speed::Works);
        Self { package, version: version.to_owned(), program: package, features, speed, why }
    }

    /// The folder that holds the program, installed if it is not there yet.
    pub fn obtain(&self) -> Result<PathBuf> {
        let folder = cache::tool(self.package, &self.version)?;
        let bin = folder.join("bin");
        if bin.join(format!("{}{}", self.program, std::env::consts::EXE_SUFFIX)).is_file() {
            return Ok(bin);
        }
        progress::announce(&format!("{} {}", self.package, self.version), self.why);
        let started = Instant::now();
        self.install(&folder).map_err(|cause| self.missing(&cause))?;
        progress::done(self.package, started);
        Ok(bin)
    }

    fn install(&self, folder: &std::path::Path) -> Result {
        cache::build_folder(folder, |partial| {
            let install = Run::new("cargo")
                .args(["install", self.package, "--version", &self.version, "--ignore-rust-version", "--root"])
                .arg(partial)
                .args(self.features.flags())
                .env("CARGO_TARGET_DIR", build_folder()?)
                .env("CARGO_PROFILE_RELEASE_LTO", "off")
                .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", self.speed.opt_level())
                .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
                .without_env("RUSTFLAGS")
                .current_dir(partial);
            install.within(BUILD_LIMIT).run()?.checked().map(|_| ())
        })
    }

    fn missing(&self, cause: &Failure) -> Failure {
        let failure = Failure::new(format!("{} {} could not be installed", self.package, self.version)).because(cause);
        let failure = failure.advice("check that cargo can reach its package registry, then run the command again");
        if find_program("cc").is_none() {
            return failure.advice("install a C linker first, on Debian: apt-get install build-essential");
        }
        failure.advice("a newer Rust may be needed: rustup update")
    }
}

/// Removes what the programs were built from.
pub fn tidy_up() -> Result {
    cache::remove_folder(&build_folder()?)
}

/// One for all: what two of the programs are made of is compiled once.
fn build_folder() -> Result<PathBuf> {
    Ok(cache::folder()?.join("build"))
}

impl Speed {
    fn opt_level(&self) -> &'static str {
        match self {
            Self::Waits => "0",
            Self::Works => "1",
        }
    }
}

impl Features {
    fn flags(&self) -> Vec<&'static str> {
        match self {
            Self::Default => Vec::new(),
            Self::Only(feature) => vec!["--no-default-features", "--features", feature],
        }
    }
}
