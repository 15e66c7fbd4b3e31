//! `cargo xtask robustness`: which faces are found in pictures of which it is known where the faces are, beside MediaPipe.

use crate::failure::{Failure, Result};
use crate::figures::Document;
use crate::process::Run;
use crate::{progress, setup, workspace};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Where the tables go.
pub const DOCUMENT: Document = Document { file: "docs/robustness.md", task: "robustness", figures: "figures" };
const LIMIT: Duration = Duration::from_secs(3600);

/// Prints the tables; `--write` puts them into the document.
pub fn run(arguments: &[&str]) -> Result<ExitCode> {
    let write = match arguments {
        [] => false,
        ["--write"] => true,
        _ => return Err(Failure::new(format!("unknown options {arguments:?}")).advice("the only option is --write")),
    };
    setup::for_tests()?;
    progress::announce("robustness", "faces turned, small, cut, dark, blurred and in groups");
    let started = Instant::now();
    let cargo = Run::new("cargo").current_dir(workspace::root()).args(["run", "--quiet", "--release", "--locked"]);
    let run = cargo.args(["--package", "rosto-landmarks", "--example", "robustness"]);
    let tables = run.within(LIMIT).run()?.checked()?;
    progress::done("robustness", started);
    println!("\n{tables}");
    if write {
        DOCUMENT.update(tables.trim_end())?;
    }
    Ok(ExitCode::SUCCESS)
}
