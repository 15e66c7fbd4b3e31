//! Builds the page for the web: a static folder that works under any path.

use crate::failure::{Failure, Result};
use crate::setup::Kit;
use crate::size::{self, Row};
use crate::{progress, setup, workspace};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const BUILD_LIMIT: Duration = Duration::from_secs(3600);

/// Builds `dist/` and shows its sizes.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_page()?;
    let started = Instant::now();
    println!("Building the page for the web; the first time takes some minutes.");
    build(&kit)?;
    let rows = size::weigh(&workspace::dist())?;
    println!("{}", size::table(&rows));
    println!("dist/ is ready ({}); serve it from any static host.", progress::elapsed(started.elapsed()));
    check(&rows)?;
    Ok(ExitCode::SUCCESS)
}

/// Builds `dist/`; returns what the build printed.
pub fn build(kit: &Kit) -> Result<String> {
    let trunk = kit.run("trunk")?.args(["build", "--release", "--color", "never"]);
    trunk.env("TRUNK_SKIP_VERSION_CHECK", "true").within(BUILD_LIMIT).run()?.checked()
}

/// Refuses a page that is larger than its budget.
pub fn check(rows: &[Row]) -> Result {
    let over: Vec<&str> = rows.iter().filter(|row| !row.fits()).map(|row| row.name.as_str()).collect();
    if over.is_empty() {
        return Ok(());
    }
    Err(Failure::new(format!("over its budget: {}", over.join(", "))))
}
