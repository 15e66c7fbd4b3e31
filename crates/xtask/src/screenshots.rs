//! `cargo xtask screenshots`: what the documentation shows of the built page: pictures of it, and axe-core's report.

use crate::failure::Result;
use crate::{dist, progress, setup};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(1200);

/// Builds the page, takes its pictures and looks it over.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_tests()?;
    progress::announce("screenshots", "the documentation shows the page as it is");
    let started = Instant::now();
    dist::build(&kit)?;
    for script in ["screenshots", "accessibility"] {
        kit.run("npm")?.args(["run", "--silent", script]).within(LIMIT).run()?.checked()?;
    }
    progress::done("screenshots", started);
    Ok(ExitCode::SUCCESS)
}
