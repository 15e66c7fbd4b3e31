//! Rust's own tools: a compiler for wasm32, rustfmt and clippy, and programs that cargo installs into the user's cache.

use crate::places::{WASM, cache, remove_folder, target};
use crate::run::{Run, announced, is_program};
use crate::system;
use anyhow::{Context, Result, ensure};
use fs_err as fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Without a route to its servers, rustup hangs.
const RUSTUP_LIMIT: Duration = Duration::from_secs(120);
const DEBIAN_PACKAGES: &str = "rustc-web cargo-web rust-web-src rust-web-clippy lld-22";

/// A program that comes from a crate.
pub struct Tool {
    package: &'static str,
    version: &'static str,
    options: &'static str,
    /// 1 for what works through megabytes; what waits for compilers is compiled as quickly as can be.
    opt_level: &'static str,
    why: &'static str,
}

/// Builds and serves the page. It must have one kind of TLS, although all that it calls is on PATH.
pub const TRUNK: Tool = Tool {
    package: "trunk",
    version: "0.22.1",
    options: "--no-default-features --features rustls",
    opt_level: "0",
    why: "it builds and serves the page",
};

/// Joins the modules to JavaScript; must be the version of the crate in `Cargo.lock`.
pub const WASM_BINDGEN: Tool = Tool {
    package: "wasm-bindgen-cli",
    version: "0.2.130",
    options: "",
    opt_level: "1",
    why: "it joins WebAssembly to JavaScript",
};

/// Runs the WebAssembly tests in a browser.
pub const WASM_PACK: Tool = Tool {
    package: "wasm-pack",
    version: "0.15.1",
    options: "",
    opt_level: "0",
    why: "it runs the WebAssembly tests in Chromium",
};

/// Drives Firefox; Debian has it in none of its packages.
pub const GECKODRIVER: Tool = Tool {
    package: "geckodriver",
    version: "0.37.1",
    options: "",
    opt_level: "0",
    why: "a test visits the page in Firefox with it",
};

/// Checks licences, bans and sources of all that is compiled.
pub const CARGO_DENY: Tool = Tool {
    package: "cargo-deny",
    version: "0.20.2",
    options: "",
    opt_level: "1",
    why: "it checks licences, bans and sources of all that is compiled",
};

/// Runs the fuzz targets with libFuzzer.
pub const CARGO_FUZZ: Tool =
    Tool { package: "cargo-fuzz", version: "0.13.2", options: "", opt_level: "0", why: "it fuzzes the readers" };

impl Tool {
    /// The folder that holds the program, installed if it is not there yet.
    pub fn obtain(&self) -> Result<PathBuf> {
        let folder = cache()?.join("tools").join(format!("{}-{}", self.package, self.version));
        // cargo writes this list last.
        if !folder.join(".crates.toml").is_file() {
            announced(self.package, self.why, || self.install(&folder))?;
        }
        Ok(folder.join("bin"))
    }

    /// Not `--locked`: a mirror need not have every version that the package was locked to.
    fn install(&self, folder: &Path) -> Result<()> {
        // One build folder for all: what two of them are made of is compiled once.
        let install =
            Run::new("cargo").words("install --ignore-rust-version").args([self.package, "--version", self.version]);
        let install = install.words(self.options).arg("--root").arg(folder).env("CARGO_TARGET_DIR", build_folder()?);
        let install = install.env("CARGO_PROFILE_RELEASE_LTO", "off").env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
        let install = install.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", self.opt_level).env("RUSTFLAGS", "");
        let installed = install.log(self.package).current_dir(cache()?).checked().map(|_| ());
        installed.with_context(|| match is_program("cc") {
            true => "let cargo reach its package registry; a newer Rust may be needed, too: rustup update",
            false => "install a C linker first, on Debian: apt-get install build-essential",
        })
    }
}

/// `cargo xtask deny`: checks every crate in `Cargo.lock`. Advisories are left to the workflow: their database changes while
/// the sources stay as they are.
pub fn deny(_: &[&str]) -> Result<()> {
    let deny = Run::new(CARGO_DENY.obtain()?.join("cargo-deny"));
    let checked = deny.words("--locked check --deny warnings licenses bans sources").command.status()?;
    ensure!(checked.success(), "a crate is not as deny.toml wants it: see what cargo-deny says above");
    Ok(())
}

/// Removes what the tools were built from.
pub fn tidy_up() -> Result<()> {
    remove_folder(&build_folder()?)
}

/// Finds or obtains a compiler for wasm32; returns its folder if it is not the present one.
pub fn for_wasm() -> Result<Option<PathBuf>> {
    if has_wasm()? {
        return Ok(None);
    }
    if let Some(built) = debian_sysroot().ok().filter(|built| built.join("bin/rustc").is_file()) {
        return Ok(Some(built));
    }
    announced("Rust's library for wasm32", "the page is compiled to WebAssembly", || {
        let Err(why) = add_wasm() else { return Ok(None) };
        println!("  · building it from Debian's sources, since rustup cannot add it: {why:#}");
        let advice = format!("add it yourself: rustup target add {WASM}; or, on Debian, make apt-get work");
        from_debian().context(advice).map(Some)
    })
}

fn add_wasm() -> Result<()> {
    rustup(&format!("target add {WASM}"))?;
    ensure!(has_wasm()?, "rustup added the target, but not to the compiler that cargo uses");
    Ok(())
}

fn from_debian() -> Result<PathBuf> {
    system::install(DEBIAN_PACKAGES)?;
    let sysroot = debian_sysroot()?;
    Run::new("sh").arg("crates/xtask/src/debian-wasm32.sh").arg(&sysroot).checked()?;
    Ok(sysroot)
}

/// Another version of Debian's compiler needs another library.
fn debian_sysroot() -> Result<PathBuf> {
    let version = Run::new("/usr/bin/rustc").arg("--version").checked()?;
    let version = version.split_whitespace().nth(1).context("rustc has no version")?;
    Ok(cache()?.join("tools").join(format!("rust-wasm32-{version}")))
}

fn has_wasm() -> Result<bool> {
    let folder = Run::new("rustc").args(["--target", WASM, "--print", "target-libdir"]).checked()?;
    Ok(fs::read_dir(folder.trim()).is_ok_and(|mut files| files.next().is_some()))
}

/// Adds rustfmt and clippy where they are missing.
pub fn components() -> Result<()> {
    for (component, command) in [("rustfmt", "fmt"), ("clippy", "clippy")] {
        if Run::new("cargo").args([command, "--version"]).run()?.success {
            continue;
        }
        announced(component, "the tests check the sources with it", || {
            rustup(&format!("component add {component}")).context("install it with your Rust")
        })?;
    }
    Ok(())
}

fn rustup(words: &str) -> Result<()> {
    ensure!(is_program("rustup"), "this machine has no rustup");
    Run::new("rustup").words(words).within(RUSTUP_LIMIT).checked().map(|_| ())
}

fn build_folder() -> Result<PathBuf> {
    let folder = cache()?.join("build");
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// The command line's program as the native tests build it.
pub fn command_line() -> Result<PathBuf> {
    over_the_workspace("test").words("--quiet --tests --no-run").log("command-line").checked()?;
    Ok(target().join("debug/rosto"))
}

/// A cargo command over the workspace without the façades, which only build for wasm32.
pub fn over_the_workspace(command: &str) -> Run {
    Run::new("cargo").words(command).words("--workspace --exclude rosto-*-web* --locked")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::places::root;

    #[test]
    fn wasm_bindgen_is_the_version_of_its_crate() {
        let lock = fs::read_to_string(root().join("Cargo.lock")).unwrap();
        assert!(lock.contains(&format!("name = \"wasm-bindgen\"\nversion = \"{}\"", WASM_BINDGEN.version)));
    }
}
