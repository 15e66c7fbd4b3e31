//! What keeps this machine's folders out of the page's modules.
//!
//! A panic's message names the source file it came from, and rustc writes there the path that it was called with: the
//! page would tell who built it, and where, and no two machines would build the same bytes.

use crate::toolchain::WASM;
use crate::workspace;
use std::path::{Path, PathBuf};

/// The variable of cargo's whose flags are added to those of `.cargo/config.toml` for wasm32, and its value.
pub fn remapped() -> (String, String) {
    let name = format!("CARGO_TARGET_{}_RUSTFLAGS", WASM.to_uppercase().replace('-', "_"));
    (name, flags(&[(workspace::root(), "rosto"), (workspace::target(), "target"), (cargo_home(), "cargo")]))
}

/// Of two that fit rustc takes the last. The variable has no way to write a space, so a folder with one in its name stays.
fn flags(folders: &[(PathBuf, &str)]) -> String {
    let spaceless = folders.iter().filter(|(folder, _)| !folder.to_string_lossy().contains(char::is_whitespace));
    let flag = |(folder, name): &(PathBuf, &str)| format!("--remap-path-prefix={}={name}", folder.display());
    spaceless.map(flag).collect::<Vec<_>>().join(" ")
}

/// Where cargo keeps the sources of all that is compiled.
fn cargo_home() -> PathBuf {
    let set = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    set.unwrap_or_else(|| std::env::home_dir().unwrap_or_else(|| Path::new("/").to_owned()).join(".cargo"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_folder_gets_a_name_that_is_the_same_everywhere() {
        let folders = [(PathBuf::from("/a/b"), "rosto"), (PathBuf::from("/c"), "cargo")];
        assert_eq!(flags(&folders), "--remap-path-prefix=/a/b=rosto --remap-path-prefix=/c=cargo");
    }

    #[test]
    fn a_folder_with_a_space_in_its_name_does_not_break_the_others() {
        let folders = [(PathBuf::from("/my files"), "rosto"), (PathBuf::from("/c"), "cargo")];
        assert_eq!(flags(&folders), "--remap-path-prefix=/c=cargo");
    }
}
