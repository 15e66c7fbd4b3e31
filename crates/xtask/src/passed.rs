//! Steps that passed on the present files, so that `cargo xtask test --all` can be continued.

use crate::places::target;
use crate::run::Run;
use anyhow::Result;
use fs_err as fs;
use std::path::PathBuf;

/// Names of the steps that passed, one per line, in a file named after the present state of all files.
pub struct Passed {
    file: PathBuf,
    names: Vec<String>,
}

impl Passed {
    /// Reads the record of the present files. A commit and its uncommitted form have the same record.
    pub fn read() -> Result<Self> {
        let folder = target().join("xtask/passed");
        fs::create_dir_all(&folder)?;
        // Another index than the user's.
        let index = folder.join("index");
        let git = |words: &str| Run::new("git").words(words).env("GIT_INDEX_FILE", &index).log("git").checked();
        git("add --all")?;
        let file = folder.join(git("write-tree")?.trim());
        let names = fs::read_to_string(&file).unwrap_or_default().lines().map(str::to_owned).collect();
        Ok(Self { file, names })
    }

    /// Whether a step has passed.
    pub fn contains(&self, step: &str) -> bool {
        self.names.iter().any(|name| name == step)
    }

    /// Records a step; a change of the files during the step is not noticed.
    pub fn add(&mut self, step: &str) -> Result<()> {
        if !self.contains(step) {
            self.names.push(step.to_owned());
        }
        Ok(fs::write(&self.file, self.names.join("\n"))?)
    }
}
