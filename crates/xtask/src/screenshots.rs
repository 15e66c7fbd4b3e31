//! `cargo xtask screenshots`: what the documentation shows of models and of the built page: pictures of them, the first minute as a
//! strip, axe-core's report, and every main state in every window, language and theme on one sheet each.

use crate::failure::Result;
use crate::process::Run;
use crate::{dist, progress, setup, workspace};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(1200);

/// Examples that draw models, and the folders in `target` that they draw into.
const MODELS: [(&str, &str); 2] = [("expression_sheet", "pictures/expressions"), ("texture", "pictures/texture")];

/// Builds the page, takes its pictures and looks it over.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_tests()?;
    progress::announce("screenshots", "the documentation shows the page as it is");
    let started = Instant::now();
    dist::build(&kit)?;
    for (example, folder) in MODELS {
        draw(example, folder)?;
    }
    // The last one fails where it finds something that overlaps, is cut or covered; the others are written by then.
    for script in ["model-pictures", "screenshots", "photo-pictures", "film-strip", "accessibility", "contact-sheet"] {
        kit.run("npm")?.args(["run", "--silent", script]).within(LIMIT).run()?.checked()?;
    }
    progress::done("screenshots", started);
    Ok(ExitCode::SUCCESS)
}

fn draw(example: &str, folder: &str) -> Result {
    let cargo = Run::new("cargo").current_dir(workspace::root()).args(["run", "--quiet", "--release", "--locked"]);
    let run =
        cargo.args(["--package", "rosto-studio", "--example", example, "--"]).arg(workspace::target().join(folder));
    run.within(LIMIT).run()?.checked()?;
    Ok(())
}
