//! Folders of this checkout, and of the user's cache, which all checkouts share.

use anyhow::{Context, Result};
use fs_err as fs;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// Target of the page's modules.
pub const WASM: &str = "wasm32-unknown-unknown";

/// Root of the workspace. Read at run time, because checkouts that share a build folder also share this program.
pub fn root() -> PathBuf {
    let here = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    Path::new(&here).ancestors().nth(2).expect("invariant: this crate lies two folders below the root").to_owned()
}

/// Build folder of cargo.
pub fn target() -> PathBuf {
    root().join(std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Logs of the last run of each program.
pub fn logs() -> Result<PathBuf> {
    let folder = target().join("xtask/logs");
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Networks and sample portrait.
pub fn assets() -> PathBuf {
    root().join("web/assets")
}

/// `$XDG_CACHE_HOME/rosto`, by default `~/.cache/rosto`.
pub fn cache() -> Result<PathBuf> {
    let from_xdg = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).filter(|path| path.is_absolute());
    let folder = from_xdg.or_else(|| Some(std::env::home_dir()?.join(".cache")));
    Ok(folder.context("no cache folder: set HOME or XDG_CACHE_HOME")?.join("rosto"))
}

/// Removes a folder if it exists.
pub fn remove_folder(folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    Ok(())
}

/// Flags for rustc that remove this machine's paths from panic messages, so that builds are reproducible.
///
/// If several prefixes match, rustc uses the last. Folders with a space in their path are not remapped, because cargo
/// splits the variable at spaces.
pub fn remapped() -> String {
    let cargo_home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let cargo_home = cargo_home.or_else(|| Some(std::env::home_dir()?.join(".cargo"))).unwrap_or_default();
    flags(&[(root(), "rosto"), (target(), "target"), (cargo_home, "cargo")])
}

fn flags(folders: &[(PathBuf, &str)]) -> String {
    let spaceless = folders.iter().filter(|(folder, _)| !folder.to_string_lossy().contains(char::is_whitespace));
    let flag = |(folder, name): &(PathBuf, &str)| format!("--remap-path-prefix={}={name}", folder.display());
    spaceless.map(flag).collect::<Vec<_>>().join(" ")
}

/// Lower-case hexadecimal SHA-256.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn skips_folders_with_a_space_in_their_path() {
        let folders =
            [(PathBuf::from("/a/b"), "rosto"), (PathBuf::from("/my files"), "rosto"), (PathBuf::from("/c"), "cargo")];
        assert_eq!(flags(&folders), "--remap-path-prefix=/a/b=rosto --remap-path-prefix=/c=cargo");
    }
}
