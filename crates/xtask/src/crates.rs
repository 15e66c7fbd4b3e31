//! The crates that are published, and whether their packages hold what they should and nothing else.

use crate::failure::{Doing, Result};
use crate::process::Run;
use crate::workspace;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// In an order in which each comes after those it needs.
pub const PUBLISHED: [&str; 4] = ["rosto-mesh", "rosto-laplacian", "rosto-photo", "rosto-landmarks"];

const LIMIT: Duration = Duration::from_secs(600);
const LICENCES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];
/// Beside the sources; all else that lies in a package, somebody has forgotten.
const MAY_HOLD: [&str; 8] = [
    ".cargo_vcs_info.json",
    "Cargo.lock",
    "Cargo.toml",
    "Cargo.toml.orig",
    "README.md",
    LICENCES[0],
    LICENCES[1],
    "examples/torus.obj",
];
const LARGEST_FILE_BYTES: u64 = 64 * 1024;

/// Packs them as for the registry, without building them, and says what is wrong with each package.
pub fn check_packages() -> Result<Vec<String>> {
    let pack = Run::new("cargo").current_dir(workspace::root()).args(["package", "--no-verify", "--allow-dirty"]);
    pack.arg("--locked").args(packages()).within(LIMIT).run()?.checked()?;
    let found = PUBLISHED.map(faults);
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

/// `--package NAME` for each.
pub fn packages<'a>() -> impl Iterator<Item = &'a str> {
    PUBLISHED.into_iter().flat_map(|name| ["--package", name])
}

fn faults(name: &str) -> Result<Vec<String>> {
    let folder = unpacked(name)?;
    let mut files = Vec::new();
    list(&folder, &mut files)?;
    let mut faults: Vec<String> = Vec::new();
    for file in &files {
        let path = file.strip_prefix(&folder).doing("naming a file of a package")?.to_string_lossy().replace('\\', "/");
        let bytes = std::fs::metadata(file).doing(format!("asking for the size of {path}"))?.len();
        faults.extend(fault(&path, bytes).map(|fault| format!("{name}: {fault}")));
    }
    for licence in LICENCES {
        let text = |folder: &Path| std::fs::read_to_string(folder.join(licence)).unwrap_or_default();
        if text(&folder) != text(&workspace::root()) {
            faults.push(format!("{name}: {licence} is not the workspace's"));
        }
    }
    if !folder.join("README.md").is_file() {
        faults.push(format!("{name}: README.md is missing"));
    }
    Ok(faults)
}

/// What is wrong with a file of a package.
fn fault(path: &str, bytes: u64) -> Option<String> {
    let is_source = path.ends_with(".rs") && (path.starts_with("src/") || path.starts_with("examples/"));
    if !is_source && !MAY_HOLD.contains(&path) {
        return Some(format!("{path} has no place in a package"));
    }
    (bytes > LARGEST_FILE_BYTES).then(|| format!("{path} has {bytes} bytes, more than {LARGEST_FILE_BYTES}"))
}

/// The package's files, where they can be looked at.
fn unpacked(name: &str) -> Result<PathBuf> {
    let packages = workspace::target().join("package");
    let version = workspace::locked_version(name)?;
    let unpacked = workspace::target().join("xtask").join("packages");
    std::fs::create_dir_all(&unpacked).doing(format!("creating {}", unpacked.display()))?;
    let folder = unpacked.join(format!("{name}-{version}"));
    crate::cache::remove_folder(&folder)?;
    let archive = packages.join(format!("{name}-{version}.crate"));
    Run::new("tar").arg("-xzf").arg(archive).arg("-C").arg(&unpacked).within(LIMIT).quietly()?.checked()?;
    Ok(folder)
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) -> Result {
    for entry in std::fs::read_dir(folder).doing(format!("listing {}", folder.display()))?.flatten() {
        let path = entry.path();
        if path.is_dir() { list(&path, files)? } else { files.push(path) }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_and_texts_may_be_in_a_package() {
        let fine = ["src/lib.rs", "src/layers/dense.rs", "examples/edit_obj.rs", "README.md", "LICENSE-MIT"];
        assert!(fine.iter().all(|path| fault(path, 100).is_none()));
    }

    #[test]
    fn fixtures_and_large_files_may_not() {
        assert!(fault("tests/golden/engine.json", 1).is_some_and(|fault| fault.contains("no place")));
        assert!(fault("src/table.bin", 1).is_some());
        assert!(fault("src/lib.rs", LARGEST_FILE_BYTES + 1).is_some_and(|fault| fault.contains("65537")));
    }

    /// A crate that one of them needs and that is not published would be found only by the registry.
    #[test]
    fn each_says_itself_that_it_is_published_and_no_other_does() {
        let folders = std::fs::read_dir(workspace::root().join("crates")).unwrap().flatten();
        let published = folders.filter(|folder| {
            let manifest = std::fs::read_to_string(folder.path().join("Cargo.toml")).unwrap_or_default();
            manifest.lines().any(|line| line == "publish = true")
        });
        let mut names: Vec<String> =
            published.map(|folder| format!("rosto-{}", folder.file_name().to_string_lossy())).collect();
        names.sort();
        let mut expected = PUBLISHED.map(str::to_owned);
        expected.sort();
        assert_eq!(names, expected);
    }
}
