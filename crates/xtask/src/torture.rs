//! `cargo xtask torture [MINUTES]`: the fuzz targets, the property tests, every browser test and the monkey test, at length.

use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::setup::{self, Kit};
use crate::{dist, test, tools, workspace};
use std::process::ExitCode;
use std::time::UNIX_EPOCH;

const TARGETS: [&str; 5] = ["picture", "profile", "glb", "project", "edits"];
/// About a minute's worth on two cores.
const CASES_PER_MINUTE: u32 = 4000;

/// Runs all parts to their end, and fails if one of them did.
pub fn run(arguments: &[&str]) -> Result<ExitCode> {
    let minutes = match arguments {
        [] => Some(10),
        [minutes] => minutes.parse().ok(),
        _ => None,
    };
    let minutes = minutes.ok_or_else(|| Failure::new("the option is a whole number: minutes for each part"))?;
    let kit = setup::for_tests()?;
    let parts = fuzz(minutes)?.into_iter().chain([properties(minutes)]).chain(browser(&kit, minutes)?);
    let succeeded = parts.map(succeeds).collect::<Result<Vec<bool>>>()?;
    Ok(if succeeded.contains(&false) { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn fuzz(minutes: u32) -> Result<Vec<Run>> {
    let fuzz = tools::cargo_fuzz().obtain()?.join("cargo-fuzz");
    let seeds = cargo(["run", "--package", "rosto-fuzz", "--example", "seeds", "tests/fuzz/corpus"]);
    let target = |target| {
        let run = ["run", "--fuzz-dir", "tests/fuzz", "--sanitizer", "none", "--features", "libfuzzer", target, "--"];
        let run = Run::new(&fuzz).args(run).args(["-timeout=10", &format!("-max_total_time={}", 60 * minutes)]);
        run.current_dir(workspace::root())
    };
    Ok([seeds].into_iter().chain(TARGETS.map(target)).collect())
}

/// Other cases in each run.
fn properties(minutes: u32) -> Run {
    let packages = ["test", "--release", "--package", "rosto-fuzz", "--package", "rosto-session"];
    let tests = cargo(packages).args(["--", "visitor", "damaged"]);
    let seed = UNIX_EPOCH.elapsed().map_or(0, |since| since.as_secs());
    tests.env("PROPTEST_CASES", (CASES_PER_MINUTE * minutes).to_string()).env("PROPTEST_RNG_SEED", seed.to_string())
}

fn browser(kit: &Kit, minutes: u32) -> Result<[Run; 2]> {
    dist::build(kit)?;
    let every = kit.run("npm")?.args(["run", "--silent", "journeys", "--", "--all"]);
    let monkey = kit.run("npm")?.args(["run", "--silent", "restless", "--", "--minutes", &minutes.to_string()]);
    Ok([every.env("ROSTO_CLI", test::command_line()?), monkey])
}

fn cargo<const N: usize>(arguments: [&str; N]) -> Run {
    Run::new("cargo").args(arguments).current_dir(workspace::root())
}

fn succeeds(part: Run) -> Result<bool> {
    let ended = part.run()?;
    println!("{}", ended.describe());
    Ok(ended.success)
}
