//! `cargo xtask screenshots`: the pictures of the documentation, taken from the built page by a script.

use crate::failure::Outcome;
use crate::{dist, progress, setup};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(1200);

/// Builds the page and takes its pictures.
pub fn run() -> Outcome<ExitCode> {
    let kit = setup::for_tests()?;
    progress::announce("screenshots", "the documentation shows the page as it is");
    let started = Instant::now();
    dist::build(&kit)?;
    kit.run("npm")?.args(["run", "--silent", "screenshots"]).within(LIMIT).run()?.checked()?;
    progress::done("screenshots", started);
    Ok(ExitCode::SUCCESS)
}
