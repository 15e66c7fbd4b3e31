//! The lines of a crate's sources that ship: no comments, no tests.

use std::fmt;
use std::path::{Path, PathBuf};

/// One line of code.
#[derive(Clone)]
pub struct Source {
    /// File and line.
    pub place: String,
    /// What stands there.
    pub code: String,
}

impl fmt::Display for Source {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.place, self.code.trim())
    }
}

/// Every line of a package, its shaders among them.
pub fn of(package: &str) -> Vec<Source> {
    let folder = match package {
        // The same sources twice, see its manifest.
        "rosto-studio-webgl" => "studio-web",
        "rosto-fuzz" => "../tests/fuzz",
        _ => package.strip_prefix("rosto-").unwrap_or(package),
    };
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    let mut files = files_below(&crate_folder.join("src"), "rs");
    assert!(!files.is_empty(), "{package} has no sources in {}", crate_folder.display());
    files.extend(files_below(&crate_folder.join("shaders"), "wgsl"));
    files.iter().flat_map(|file| lines(file)).collect()
}

fn lines(file: &Path) -> Vec<Source> {
    let text = std::fs::read_to_string(file).unwrap();
    let shipped = text.lines().take_while(|line| !begins_tests(line)).enumerate();
    let code = shipped.filter(|(_, line)| !line.trim_start().starts_with("//"));
    code.map(|(index, line)| Source { place: format!("{}:{}", file.display(), index + 1), code: line.to_owned() })
        .collect()
}

fn begins_tests(line: &str) -> bool {
    ["#[cfg(test)]", "#[cfg(all(test"].iter().any(|attribute| line.trim_start().starts_with(attribute))
}

fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path, ending));
        } else if path.extension().is_some_and(|extension| extension == ending) {
            files.push(path);
        }
    }
    files
}
