//! `cargo xtask screenshots`: what the documentation shows of the built page: pictures of it, the first minute as a
//! strip, axe-core's report, and every main state in every window, language and theme on one sheet each.

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
    // The last one fails where it finds something that overlaps, is cut or covered; the others are written by then.
    for script in ["screenshots", "photo-pictures", "film-strip", "accessibility", "contact-sheet"] {
        kit.run("npm")?.args(["run", "--silent", script]).within(LIMIT).run()?.checked()?;
    }
    progress::done("screenshots", started);
    Ok(ExitCode::SUCCESS)
}
