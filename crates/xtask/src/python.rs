//! Virtual environments of Python in the user's cache, each made anew when its pinned versions change.

use crate::failure::{Doing, Failure, Result};
use crate::process::Run;
use crate::{cache, workspace};
use std::path::{Path, PathBuf};
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(3600);

/// A virtual environment.
pub struct Environment {
    folder: PathBuf,
}

impl Environment {
    /// The environment for what these files of requirements name, empty if it is new.
    pub fn obtain(requirements: &[&str]) -> Result<Self> {
        let versions = requirements.iter().map(|file| cache::sha256_of(&workspace::root().join(file)));
        let identity = versions.collect::<Result<Vec<_>>>()?.concat();
        let folder = cache::tool("python", &cache::sha256(identity.as_bytes())[..16])?;
        let environment = Self { folder };
        environment.once("made", || make(&environment.folder))?;
        Ok(environment)
    }

    /// Its interpreter.
    pub fn python(&self) -> PathBuf {
        self.folder.join("bin").join("python")
    }

    /// Whether a file of requirements is installed.
    pub fn has(&self, requirements: &str) -> bool {
        self.folder.join(mark_of(requirements)).is_file()
    }

    /// Installs what a file of requirements names, unless it is there.
    pub fn install(&self, requirements: &str) -> Result {
        let file = workspace::root().join(requirements);
        self.once(&mark_of(requirements), || self.pip(&["-r".as_ref(), file.as_path()]))
    }

    /// Installs as many of the packages that a file of requirements names, with all that they need, as there are for this
    /// Python; returns why for each of the others.
    pub fn install_each(&self, requirements: &str) -> Result<Vec<Failure>> {
        let listed = std::fs::read_to_string(workspace::root().join(requirements)).doing("reading requirements")?;
        let mut lost = Vec::new();
        for entry in entries(&listed) {
            // pip takes hashes from files alone.
            let alone = self.folder.join("one-requirement.txt");
            cache::write(&alone, entry)?;
            if let Err(cause) = self.pip(&["--no-deps".as_ref(), "-r".as_ref(), alone.as_path()]) {
                let package = entry.split_whitespace().next().unwrap_or(entry);
                lost.push(Failure::new(format!("{package} does not install for this Python")).because(&cause));
            }
        }
        Ok(lost)
    }

    fn pip(&self, wanted: &[&Path]) -> Result {
        let pip = Run::new(self.python()).args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        pip.args(wanted).within(LIMIT).run()?.checked().map(|_| ())
    }

    fn once(&self, mark: &str, work: impl FnOnce() -> Result) -> Result {
        let mark = self.folder.join(mark);
        if mark.is_file() {
            return Ok(());
        }
        work()?;
        cache::write(&mark, "")
    }
}

/// A virtual environment knows its own path, so it is made in place.
fn make(folder: &Path) -> Result {
    cache::remove_folder(folder)?;
    Run::new("python3").args(["-m", "venv"]).arg(folder).within(LIMIT).run()?.checked().map_err(|cause| {
        let failure = Failure::new("a virtual environment of Python could not be made").because(&cause);
        failure.advice("install Python 3 with venv, on Debian: apt-get install python3-venv")
    })?;
    Ok(())
}

fn mark_of(requirements: &str) -> String {
    format!("complete-{}", requirements.replace('/', "-"))
}

/// The packages of a file of requirements, each with its hashes on the lines that follow.
fn entries(requirements: &str) -> Vec<&str> {
    let starts = requirements.match_indices('\n').map(|(at, _)| at + 1).chain([0]);
    let is_start = |at: &usize| requirements[*at..].starts_with(|first: char| first.is_ascii_alphanumeric());
    let mut starts: Vec<usize> = starts.filter(is_start).collect();
    starts.sort_unstable();
    let ends = starts.iter().skip(1).copied().chain([requirements.len()]);
    starts.iter().zip(ends).map(|(&start, end)| &requirements[start..end]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_keeps_the_hashes_that_follow_it() {
        let entries = entries("# what for\na==1 \\\n    --hash=sha256:0 \\\n    --hash=sha256:1\nb==2\n");
        assert_eq!(entries, ["a==1 \\\n    --hash=sha256:0 \\\n    --hash=sha256:1\n", "b==2\n"]);
    }
}
