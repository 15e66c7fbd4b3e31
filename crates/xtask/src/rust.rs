//! Rust's tools: a compiler for wasm32, rustfmt and clippy, and programs that cargo installs into the user's cache.

use crate::places::{WASM, cache, remove_folder, target};
use crate::run::{Run, announced, is_program};
use crate::system;
use anyhow::{Context, Result, ensure};
use fs_err as fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// rustup hangs without a route to its servers.
const RUSTUP_LIMIT: Duration = Duration::from_secs(120);
const DEBIAN_PACKAGES: &str = "rustc-web cargo-web rust-web-src rust-web-clippy lld-22";

/// A program installed from a crate.
pub struct Tool {
    package: &'static str,
    version: &'static str,
    options: &'static str,
    /// Crates that process megabytes, which are optimised. The others compile faster without.
    optimised: &'static [&'static str],
    why: &'static str,
}

/// Builds and serves the page. It needs a TLS feature to compile, although it downloads nothing.
pub const TRUNK: Tool = Tool {
    package: "trunk",
    version: "0.22.1",
    options: "--no-default-features --features rustls",
    optimised: &[],
    why: "builds and serves the page",
};

/// Generates the modules' JavaScript; must have the version of the crate in `Cargo.lock`.
pub const WASM_BINDGEN: Tool = Tool {
    package: "wasm-bindgen-cli",
    version: "0.2.130",
    options: "",
    optimised: &["walrus", "wasm-bindgen-cli-support", "wasm-encoder", "wasmparser"],
    why: "generates JavaScript bindings",
};

/// Runs the WebAssembly tests in a browser.
pub const WASM_PACK: Tool =
    Tool { package: "wasm-pack", version: "0.15.1", options: "", optimised: &[], why: "runs the WebAssembly tests" };

/// Checks licences, bans and sources of dependencies.
pub const CARGO_DENY: Tool =
    Tool { package: "cargo-deny", version: "0.20.2", options: "", optimised: &[], why: "checks dependencies" };

/// Runs the fuzz targets with libFuzzer.
pub const CARGO_FUZZ: Tool =
    Tool { package: "cargo-fuzz", version: "0.13.2", options: "", optimised: &[], why: "runs the fuzz targets" };

impl Tool {
    /// Returns the folder that contains the program; installs it if necessary.
    pub fn obtain(&self) -> Result<PathBuf> {
        let folder = cache()?.join("tools").join(format!("{}-{}", self.package, self.version));
        // cargo writes this file last.
        if !folder.join(".crates.toml").is_file() {
            announced(self.package, self.why, || self.install(&folder))?;
        }
        Ok(folder.join("bin"))
    }

    /// Installs without `--locked`, because a mirror may lack some of the locked versions.
    fn install(&self, folder: &Path) -> Result<()> {
        // A shared build folder compiles common dependencies once.
        let level = |name: &&str| format!("profile.release.package.{name}.opt-level=1");
        let cargo =
            self.optimised.iter().map(level).fold(Run::new("cargo"), |run, level| run.arg("--config").arg(level));
        let install = cargo.words("install --ignore-rust-version").args([self.package, "--version", self.version]);
        let install = install.words(self.options).arg("--root").arg(folder).env("CARGO_TARGET_DIR", build_folder()?);
        let install = install.env("CARGO_PROFILE_RELEASE_LTO", "off").env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
        let install = install.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0").env("RUSTFLAGS", "");
        let installed = install.log(self.package).current_dir(cache()?).checked().map(|_| ());
        installed.with_context(|| match is_program("cc") {
            true => "cargo must reach its package registry; you may also need a newer Rust: rustup update",
            false => "install a C linker (on Debian: apt-get install build-essential)",
        })
    }
}

/// `cargo xtask deny`: checks the crates in `Cargo.lock`. The workflow checks advisories, whose database changes
/// independently of the sources.
pub fn deny(_: &[&str]) -> Result<()> {
    let deny = Run::new(CARGO_DENY.obtain()?.join("cargo-deny"));
    let checked = deny.words("--locked check --deny warnings licenses bans sources").command.status()?;
    ensure!(checked.success(), "a crate violates deny.toml; see above");
    Ok(())
}

/// Removes the tools' build folder.
pub fn tidy_up() -> Result<()> {
    remove_folder(&build_folder()?)
}

/// Finds or installs a compiler for wasm32; returns its folder if it is not the current one.
pub fn for_wasm() -> Result<Option<PathBuf>> {
    if has_wasm()? {
        return Ok(None);
    }
    if let Some(built) = debian_sysroot().ok().filter(|built| built.join("bin/rustc").is_file()) {
        return Ok(Some(built));
    }
    announced("Rust's library for wasm32", "compiles the page to WebAssembly", || {
        let Err(why) = add_wasm() else { return Ok(None) };
        println!("  · rustup cannot add it ({why:#}); building it from Debian's sources");
        let advice = format!("run `rustup target add {WASM}`, or make apt-get work on Debian");
        from_debian().context(advice).map(Some)
    })
}

fn add_wasm() -> Result<()> {
    rustup(&format!("target add {WASM}"))?;
    ensure!(has_wasm()?, "rustup added the target to another toolchain than the one that cargo uses");
    Ok(())
}

fn from_debian() -> Result<PathBuf> {
    system::install(DEBIAN_PACKAGES)?;
    let sysroot = debian_sysroot()?;
    Run::new("sh").arg("crates/xtask/src/debian-wasm32.sh").arg(&sysroot).checked()?;
    Ok(sysroot)
}

/// The folder name contains the compiler's version, because the library must match it.
fn debian_sysroot() -> Result<PathBuf> {
    let version = Run::new("/usr/bin/rustc").arg("--version").checked()?;
    let version = version.split_whitespace().nth(1).context("rustc has no version")?;
    Ok(cache()?.join("tools").join(format!("rust-wasm32-{version}")))
}

fn has_wasm() -> Result<bool> {
    let folder = Run::new("rustc").args(["--target", WASM, "--print", "target-libdir"]).checked()?;
    Ok(fs::read_dir(folder.trim()).is_ok_and(|mut files| files.next().is_some()))
}

/// Installs rustfmt and clippy if they are missing.
pub fn components() -> Result<()> {
    for (component, command) in [("rustfmt", "fmt"), ("clippy", "clippy")] {
        if Run::new("cargo").args([command, "--version"]).run()?.success {
            continue;
        }
        announced(component, "checks the sources", || {
            rustup(&format!("component add {component}")).context("install it with your Rust toolchain")
        })?;
    }
    Ok(())
}

fn rustup(words: &str) -> Result<()> {
    ensure!(is_program("rustup"), "rustup not found");
    Run::new("rustup").words(words).within(RUSTUP_LIMIT).checked().map(|_| ())
}

fn build_folder() -> Result<PathBuf> {
    let folder = cache()?.join("build");
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Builds the command line as the native tests do, and returns its path.
pub fn command_line() -> Result<PathBuf> {
    over_the_workspace("test").words("--quiet --tests --no-run").log("command-line").checked()?;
    Ok(target().join("debug/rosto"))
}

/// A cargo command for the workspace without the page's modules, which build for wasm32 alone.
pub fn over_the_workspace(command: &str) -> Run {
    compiled_by_clippy(Run::new("cargo").words(command).words("--workspace --exclude rosto-studio-web* --locked"))
}

/// Lets clippy compile the workspace's crates and deny warnings: one build is linted and tested, with one build of the
/// dependencies. Only for tests, because clippy switches some optimisations off.
pub fn compiled_by_clippy(cargo: Run) -> Run {
    cargo.env("RUSTC_WORKSPACE_WRAPPER", "clippy-driver").env("CLIPPY_ARGS", "-Dwarnings")
}

/// Native tests, in several programs at once if nextest is installed.
pub fn native_tests(includes_slow: bool) -> Run {
    let (runner, slow) = match is_program("cargo-nextest") {
        true => ("nextest run --tests --no-fail-fast", " --run-ignored all"),
        false => ("test --tests --no-fail-fast", " -- --include-ignored"),
    };
    over_the_workspace(runner).words(if includes_slow { slow } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::places::root;

    #[test]
    fn wasm_bindgen_has_the_version_in_the_lock_file() {
        let lock = fs::read_to_string(root().join("Cargo.lock")).unwrap();
        assert!(lock.contains(&format!("name = \"wasm-bindgen\"\nversion = \"{}\"", WASM_BINDGEN.version)));
    }
}
