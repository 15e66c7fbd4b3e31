//! The user's cache, shared by all checkouts: what is in it is never fetched or built again.
//!
//! A folder appears in the cache under its final name only when it is complete.

use crate::failure::{Doing, Failure, Result};
use crate::versions::PinnedFile;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// `$XDG_CACHE_HOME/rosto`, by default `~/.cache/rosto`.
pub fn folder() -> Result<PathBuf> {
    let from_xdg = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).filter(|path| path.is_absolute());
    let base = from_xdg.or_else(|| std::env::home_dir().map(|home| home.join(".cache")));
    let base = base.ok_or_else(|| {
        Failure::new("there is no place for the tools: neither XDG_CACHE_HOME nor HOME is set").advice("set HOME")
    })?;
    Ok(base.join("rosto"))
}

/// The folder of a tool at a version.
pub fn tool(name: &str, version: &str) -> Result<PathBuf> {
    Ok(folder()?.join("tools").join(format!("{name}-{version}")))
}

/// The folder of something downloaded, at a version.
pub fn download(name: &str, version: &str) -> Result<PathBuf> {
    Ok(folder()?.join("downloads").join(format!("{name}-{version}")))
}

/// Makes `folder` by filling a folder beside it and moving it into place once `fill` succeeds.
pub fn build_folder(folder: &Path, fill: impl FnOnce(&Path) -> Result) -> Result {
    let mut name = folder.file_name().expect("invariant: a cached folder has a name").to_owned();
    name.push(format!(".partial-{}", std::process::id()));
    let partial = folder.with_file_name(name);
    std::fs::create_dir_all(&partial).doing(format!("creating {}", partial.display()))?;
    let filled = fill(&partial);
    if filled.is_ok() {
        remove_folder(folder)?;
        std::fs::rename(&partial, folder).doing(format!("moving {} into place", folder.display()))?;
    } else {
        remove_folder(&partial)?;
    }
    filled
}

/// Refuses a file in `folder` whose sha256 is not the pinned one.
pub fn check(folder: &Path, pinned: &PinnedFile) -> Result<PathBuf> {
    let file = folder.join(pinned.path);
    let found = sha256_of(&file)?;
    if found == pinned.sha256 {
        return Ok(file);
    }
    Err(Failure::new(format!("{} is not the file it should be", file.display()))
        .tried(format!("its sha256 is {found}, expected {}", pinned.sha256))
        .advice("delete it and run the command again; if this repeats, do not trust the download"))
}

/// Lower-case hexadecimal sha256 of a file.
pub fn sha256_of(file: &Path) -> Result<String> {
    let bytes = std::fs::read(file).doing(format!("reading {}", file.display()))?;
    Ok(sha256(&bytes))
}

/// Lower-case hexadecimal sha256 of bytes.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Copies a file, creating the folder it goes to.
pub fn copy(from: &Path, to: &Path) -> Result {
    let folder = to.parent().expect("invariant: a file's path has a parent");
    std::fs::create_dir_all(folder).doing(format!("creating {}", folder.display()))?;
    std::fs::copy(from, to).doing(format!("copying {} to {}", from.display(), to.display())).map(|_| ())
}

/// Writes a small file, creating the folder it goes to.
pub fn write(file: &Path, contents: impl AsRef<[u8]>) -> Result {
    let folder = file.parent().expect("invariant: a file's path has a parent");
    std::fs::create_dir_all(folder).doing(format!("creating {}", folder.display()))?;
    std::fs::write(file, contents).doing(format!("writing {}", file.display()))
}

/// Lets a script be run as a program.
pub fn make_executable(file: &Path) -> Result {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let permissions = std::fs::Permissions::from_mode(0o755);
        std::fs::set_permissions(file, permissions).doing(format!("making {} executable", file.display()))?;
    }
    Ok(())
}

/// Removes a file.
pub fn remove_file(file: &Path) -> Result {
    std::fs::remove_file(file).doing(format!("removing {}", file.display()))
}

/// Removes a folder if it is there.
pub fn remove_folder(folder: &Path) -> Result {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(Failure::new(format!("removing {}: {error}", folder.display())))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("rosto-xtask-test-{}-{name}", std::process::id()));
        remove_folder(&folder).unwrap();
        folder
    }

    #[test]
    fn sha256_is_the_published_one_of_abc() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn a_changed_file_is_refused() {
        let folder = scratch("pinned");
        let pinned =
            PinnedFile { path: "file", sha256: "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad" };
        write(&folder.join("file"), "abc").unwrap();
        assert!(check(&folder, &pinned).is_ok());
        write(&folder.join("file"), "abd").unwrap();
        let message = check(&folder, &pinned).unwrap_err().to_string();
        assert!(message.contains("sha256"), "{message}");
        remove_folder(&folder).unwrap();
    }

    #[test]
    fn a_folder_that_could_not_be_filled_does_not_appear() {
        let folder = scratch("partial");
        let outcome = build_folder(&folder, |partial| {
            write(&partial.join("half"), "")?;
            Err(Failure::new("no more"))
        });
        assert!(outcome.is_err());
        assert!(!folder.exists());
        build_folder(&folder, |partial| write(&partial.join("whole"), "")).unwrap();
        assert!(folder.join("whole").is_file());
        remove_folder(&folder).unwrap();
    }
}
