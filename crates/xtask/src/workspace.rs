//! Where things are in this checkout.

use crate::failure::{Doing, Failure, Result};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The folder with the workspace's `Cargo.toml`. Cargo says which when it runs this: checkouts that share a build folder share
/// the program, too.
pub fn root() -> PathBuf {
    let here = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    Path::new(&here).ancestors().nth(2).expect("invariant: this crate lies two folders below the root").to_owned()
}

/// Cargo's build folder.
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |folder| root().join(folder))
}

/// Where the logs of the tasks' steps are kept.
pub fn logs() -> Result<PathBuf> {
    let folder = target().join("xtask").join("logs");
    std::fs::create_dir_all(&folder).doing(format!("creating {}", folder.display()))?;
    Ok(folder)
}

/// What the page serves beside its code: the networks and the sample portrait.
pub fn assets() -> PathBuf {
    root().join("web").join("assets")
}

/// The built page.
pub fn dist() -> PathBuf {
    root().join("dist")
}

/// The version of `package` in `Cargo.lock`.
pub fn locked_version(package: &str) -> Result<String> {
    let lock = std::fs::read_to_string(root().join("Cargo.lock")).doing("reading Cargo.lock")?;
    version_in_lock(&lock, package).ok_or_else(|| Failure::new(format!("Cargo.lock has no package `{package}`")))
}

/// PATH with `folders` in front.
pub fn path_with(folders: &[PathBuf]) -> Result<OsString> {
    let present = std::env::var_os("PATH").unwrap_or_default();
    let all = folders.iter().cloned().chain(std::env::split_paths(&present));
    std::env::join_paths(all).doing("putting PATH together")
}

fn version_in_lock(lock: &str, package: &str) -> Option<String> {
    let wanted = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != wanted);
    let version = lines.nth(1)?.strip_prefix("version = \"")?;
    Some(version.strip_suffix('"')?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_a_version_from_the_lock_file() {
        let lock = "[[package]]\nname = \"wasm-bindgen-macro\"\nversion = \"9.9.9\"\n\n\
                    [[package]]\nname = \"wasm-bindgen\"\nversion = \"0.2.130\"\n";
        assert_eq!(version_in_lock(lock, "wasm-bindgen").as_deref(), Some("0.2.130"));
        assert_eq!(version_in_lock(lock, "bindgen"), None);
    }

    #[test]
    fn the_root_holds_the_lock_file() {
        assert!(root().join("Cargo.lock").is_file());
    }
}
