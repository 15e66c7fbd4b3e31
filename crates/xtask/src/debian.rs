//! The wasm32 standard library where rustup cannot download one: built from Debian's sources with Debian's compiler.
//!
//! The system's folders stay as the packages left them. A sysroot in the user's cache joins the compiler's own
//! libraries, by link, with the wasm32 library built here; small scripts named `rustc` and `cargo` point Debian's
//! programs at it.

use crate::failure::{Doing, Failure, Result};
use crate::process::Run;
use crate::toolchain::{WASM, has_target};
use crate::{apt, cache, versions};
use std::path::{Path, PathBuf};
use std::time::Duration;

const RUSTC: &str = "/usr/bin/rustc";
const CARGO: &str = "/usr/bin/cargo";
const BUILD_LIMIT: Duration = Duration::from_secs(1800);

/// The sysroot, if it has been built for the compiler that Debian's packages provide now.
pub fn already_built() -> Result<Option<PathBuf>> {
    let Ok(version) = version() else { return Ok(None) };
    let folder = cache::tool("rust-wasm32", &version)?;
    Ok(has_target(&folder).then_some(folder))
}

/// Installs the packages and builds the sysroot.
pub fn build() -> Result<PathBuf> {
    apt::install(&versions::DEBIAN_TOOLCHAIN)?;
    let folder = cache::tool("rust-wasm32", &version()?)?;
    cache::build_folder(&folder, |partial| {
        build_library(partial)?;
        link_host(partial)?;
        write_programs(partial, &folder)
    })?;
    Ok(folder)
}

fn version() -> Result<String> {
    let printed = Run::new(RUSTC).arg("--version").quietly()?.checked()?;
    let version = printed.split_whitespace().nth(1).map(str::to_owned);
    version.ok_or_else(|| Failure::new(format!("{RUSTC} does not say its version: {printed}")))
}

fn build_library(sysroot: &Path) -> Result {
    let empty = sysroot.join("empty");
    let manifest = "[package]\nname = \"empty\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n";
    cache::write(&empty.join("Cargo.toml"), manifest)?;
    cache::write(&empty.join("src/lib.rs"), "#![no_std]\n")?;
    let build = Run::new(CARGO).args(["build", "--release", "-Z", "build-std=std,panic_abort,test", "--target", WASM]);
    let build = build.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", RUSTC).env("CARGO_TARGET_DIR", empty.join("target"));
    let build = build.without_env("RUSTUP_TOOLCHAIN").without_env("RUSTFLAGS").without_env("CARGO");
    build.current_dir(&empty).within(BUILD_LIMIT).run()?.checked()?;
    let built = empty.join("target").join(WASM).join("release/deps");
    let libraries = sysroot.join("lib/rustlib").join(WASM).join("lib");
    for entry in std::fs::read_dir(&built).doing("listing the library just built")?.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".rlib") && !name.starts_with("libempty-") {
            cache::copy(&entry.path(), &libraries.join(name))?;
        }
    }
    std::fs::remove_dir_all(&empty).doing("removing the build folder")
}

/// The host's libraries and linkers, by link, so that build scripts and procedural macros compile.
fn link_host(sysroot: &Path) -> Result {
    let rustlib = Path::new("/usr/lib/rustlib");
    for entry in std::fs::read_dir(rustlib).doing("listing Debian's Rust libraries")?.flatten() {
        let host = sysroot.join("lib/rustlib").join(entry.file_name());
        if entry.file_name() == WASM || !entry.path().join("lib").is_dir() {
            continue;
        }
        std::fs::create_dir_all(host.join("bin")).doing("creating the sysroot")?;
        link(&entry.path().join("lib"), &host.join("lib"))?;
        link(Path::new("/usr/bin/lld-22"), &host.join("bin/rust-lld"))?;
    }
    Ok(())
}

fn write_programs(partial: &Path, sysroot: &Path) -> Result {
    let bin = partial.join("bin");
    let at = sysroot.display();
    program(&bin, "rustc", &format!("exec {RUSTC} --sysroot '{at}' \"$@\""))?;
    // clippy-driver reads SYSROOT; cargo-clippy finds it beside itself.
    let cargo = format!("export RUSTC='{at}/bin/rustc' SYSROOT='{at}'\nexec {CARGO} \"$@\"");
    program(&bin, "cargo", &cargo)?;
    for name in ["cargo-clippy", "clippy-driver", "rustdoc"] {
        let file = Path::new("/usr/bin").join(name);
        if file.exists() {
            link(&file, &bin.join(name))?;
        }
    }
    Ok(())
}

fn program(bin: &Path, name: &str, script: &str) -> Result {
    let file = bin.join(name);
    cache::write(&file, format!("#!/bin/sh\n{script}\n"))?;
    cache::make_executable(&file)
}

#[cfg(unix)]
fn link(original: &Path, link: &Path) -> Result {
    std::os::unix::fs::symlink(original, link).doing(format!("linking {}", link.display()))
}

#[cfg(not(unix))]
fn link(original: &Path, _: &Path) -> Result {
    Err(Failure::new(format!("{} exists on Debian only", original.display())))
}
