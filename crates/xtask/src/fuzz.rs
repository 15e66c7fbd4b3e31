//! `cargo xtask fuzz [MINUTES]`: fuzz targets, property tests with new cases, end-to-end tests and monkey test.

use crate::page;
use crate::run::{Run, elapsed, last_lines};
use crate::rust::{self, CARGO_FUZZ};
use crate::setup::{self, Kit};
use anyhow::{Context, Result, ensure};
use std::time::{Duration, Instant, UNIX_EPOCH};

const TARGETS: [&str; 5] = ["picture", "profile", "glb", "project", "edits"];
/// About one minute on two cores.
const CASES_PER_MINUTE: u32 = 4000;
const RUNS_PER_MINUTE: u32 = 3;
const LIMIT: Duration = Duration::from_secs(24 * 3600);
const SHOWN_LINES: usize = 100;

/// Runs each part for about `MINUTES`; fails if a part fails.
pub fn run(arguments: &[&str]) -> Result<()> {
    let minutes = arguments.first().map_or(Ok(10), |minutes| minutes.parse());
    let minutes = minutes.context("MINUTES must be a whole number")?;
    let kit = setup::for_tests()?;
    let parts = fuzz(minutes)?.into_iter().chain([properties(minutes)]).chain(browser(&kit, minutes)?);
    let failed = parts.map(is_failure).collect::<Result<Vec<bool>>>()?.into_iter().filter(|failed| *failed).count();
    ensure!(failed == 0, "{failed} parts failed; see above");
    Ok(())
}

fn fuzz(minutes: u32) -> Result<Vec<Run>> {
    let fuzz = CARGO_FUZZ.obtain()?.join("cargo-fuzz");
    let seeds = Run::new("cargo").words("run --package rosto-fuzz --example seeds tests/fuzz/corpus").log("seeds");
    let target = |target| {
        let run = Run::new(&fuzz).words("run --fuzz-dir tests/fuzz --sanitizer none --features libfuzzer");
        let run = run.args([target, "--", "-timeout=10", &format!("-max_total_time={}", 60 * minutes)]);
        run.log(&format!("fuzz-{target}"))
    };
    Ok([seeds].into_iter().chain(TARGETS.map(target)).collect())
}

/// Property tests with new cases in each run.
fn properties(minutes: u32) -> Run {
    let tests =
        Run::new("cargo").words("test --release --package rosto-fuzz --package rosto-session -- random:: damaged");
    let seed = UNIX_EPOCH.elapsed().map_or(0, |since| since.as_secs());
    let tests = tests.env("PROPTEST_CASES", (CASES_PER_MINUTE * minutes).to_string()).log("properties");
    tests.env("PROPTEST_RNG_SEED", seed.to_string())
}

fn browser(kit: &Kit, minutes: u32) -> Result<[Run; 2]> {
    page::build(kit)?;
    let every = kit.npm("e2e:all").env("ROSTO_CLI", rust::command_line()?).log("e2e-all");
    let runs = (RUNS_PER_MINUTE * minutes).to_string();
    Ok([every, kit.npm("monkey").args(["--", "--runs", &runs]).log("monkey")])
}

fn is_failure(part: Run) -> Result<bool> {
    let started = Instant::now();
    let ended = part.within(LIMIT).run()?;
    println!("{}\n  {}", last_lines(&ended.output, SHOWN_LINES), elapsed(started.elapsed()));
    Ok(!ended.success)
}
