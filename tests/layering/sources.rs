//! Looking through the sources of crates.

use std::path::{Path, PathBuf};

/// Fails if a word stands in the sources of one of these packages, outside comments and tests.
pub fn assert_absent(packages: &[&str], words: &[&str]) {
    let found: Vec<String> = packages.iter().flat_map(|package| find(package, words)).collect();
    assert!(found.is_empty(), "not allowed here:\n{}", found.join("\n"));
}

fn find(package: &str, words: &[&str]) -> Vec<String> {
    let folder = package.strip_prefix("rosto-").unwrap();
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder).join("src");
    let files = rust_files(&sources);
    assert!(!files.is_empty(), "{package} has no sources at {}", sources.display());
    files.iter().flat_map(|file| find_in(file, words)).collect()
}

fn find_in(file: &Path, words: &[&str]) -> Vec<String> {
    let text = std::fs::read_to_string(file).unwrap();
    let shipped = text.lines().take_while(|line| !begins_tests(line)).enumerate();
    let code = shipped.filter(|(_, line)| !line.trim_start().starts_with("//"));
    code.filter(|(_, line)| words.iter().any(|word| line.contains(word)))
        .map(|(index, line)| format!("{}:{}: {}", file.display(), index + 1, line.trim()))
        .collect()
}

fn begins_tests(line: &str) -> bool {
    ["#[cfg(test)]", "#[cfg(all(test"].iter().any(|attribute| line.trim_start().starts_with(attribute))
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}
