//! Steps that passed on the present files, so that `cargo xtask test --all` can be continued.

use crate::places::target;
use crate::run::Run;
use anyhow::Result;
use fs_err as fs;
use std::path::PathBuf;

/// Names of the steps that passed.
#[derive(Default)]
pub struct Passed {
    /// The record: one name per line, in a file named after the state of all sources; none without git.
    file: Option<PathBuf>,
    names: Vec<String>,
}

impl Passed {
    /// Reads the record of the present files; an empty one without git.
    pub fn read() -> Self {
        let Ok(file) = record() else { return Self::default() };
        let names = fs::read_to_string(&file).unwrap_or_default().lines().map(str::to_owned).collect();
        Self { file: Some(file), names }
    }

    /// Whether a step has passed.
    pub fn contains(&self, step: &str) -> bool {
        self.names.iter().any(|name| name == step)
    }

    /// Records a step.
    pub fn add(&mut self, step: &str) -> Result<()> {
        if !self.contains(step) {
            self.names.push(step.to_owned());
        }
        self.file.iter().try_for_each(|file| Ok(fs::write(file, self.names.join("\n"))?))
    }
}

/// File of the present sources. A commit and its uncommitted form have the same one.
fn record() -> Result<PathBuf> {
    let folder = target().join("xtask/passed");
    fs::create_dir_all(&folder)?;
    // Another index than the user's.
    let index = folder.join("index");
    let git = |words: &str| Run::new("git").words(words).env("GIT_INDEX_FILE", &index).log("git").checked();
    git("add --all")?;
    Ok(folder.join(git("write-tree")?.trim()))
}
