//! `cargo xtask site`: the documentation as a static site.

use crate::failure::Result;
use crate::process::Run;
use crate::setup::Kit;
use crate::{progress, setup, test, workspace};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(300);

/// Builds the site into `target/site`.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_page()?;
    println!("Building the command line, which says of itself what the reference has.");
    let started = Instant::now();
    println!("{}", build(&kit, test::command_line()?)?.trim());
    println!("{} is ready ({}).", folder().join("index.html").display(), progress::elapsed(started.elapsed()));
    Ok(ExitCode::SUCCESS)
}

/// Builds the site; `program` is the command line's.
pub fn build(kit: &Kit, program: PathBuf) -> Result<String> {
    let build = kit.run("node")?.arg("docs/site/build.mjs").arg(folder()).env("ROSTO_CLI", program);
    build.within(LIMIT).run()?.checked()
}

/// The tests of the site and of all links in the documentation.
pub fn tests(kit: &Kit) -> Result<Run> {
    let node = kit.run("node")?.args(["--test", "--test-reporter", "spec", "tests/docs/site.test.mjs"]);
    Ok(node.env("ROSTO_SITE", folder()))
}

fn folder() -> PathBuf {
    workspace::target().join("site")
}
