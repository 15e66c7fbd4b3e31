//! `cargo xtask test`: every check of the workspace, one closing line.
//!
//! All steps run even when one fails; what a failing step printed is shown in full, and what failed is named once more
//! at the end, where a log that was cut still has it.

mod counts;
mod steps;

use crate::failure::{Failure, Result};
use crate::{progress, setup};
use counts::Counts;
use std::process::ExitCode;
use std::time::Instant;
pub use steps::command_line;
use steps::{Report, Step};

/// Runs all steps, or those named, and closes with one line `N passed, N failed`.
pub fn run(wanted: &[&str]) -> Result<ExitCode> {
    let all = steps::all()?;
    let chosen = choose(all, wanted)?;
    let mut failing = Vec::new();
    let total = match setup::for_tests() {
        Ok(kit) => {
            let counts = chosen.into_iter().map(|step| run_step(&kit, step, &mut failing));
            counts.fold(Counts::default(), Counts::plus)
        }
        Err(failure) => {
            println!("✗ set-up: {failure}");
            Counts { passed: 0, failed: 1 }
        }
    };
    println!();
    failing.iter().for_each(|line| println!("✗ {line}"));
    println!("{} passed, {} failed", total.passed, total.failed);
    Ok(if total.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn choose(all: Vec<Step>, wanted: &[&str]) -> Result<Vec<Step>> {
    let unknown = wanted.iter().find(|name| !all.iter().any(|step| step.is_called(name)));
    if let Some(name) = unknown {
        let names: Vec<&str> = all.iter().map(|step| step.name.as_str()).collect();
        return Err(Failure::new(format!("`{name}` is no step")).advice(format!("the steps are {}", names.join(", "))));
    }
    Ok(all.into_iter().filter(|step| wanted.is_empty() || wanted.iter().any(|name| step.is_called(name))).collect())
}

/// Adds to `failing` what failed of the step.
fn run_step(kit: &setup::Kit, step: Step, failing: &mut Vec<String>) -> Counts {
    println!("▸ {} ({})", step.name, step.what);
    let started = Instant::now();
    let report = (step.work)(kit).unwrap_or_else(|failure| Report::failed(failure.to_string()));
    let Counts { passed, failed } = report.counts;
    let mark = if failed == 0 { "✓" } else { "✗" };
    if failed > 0 {
        println!("{}", report.output.trim_end());
        failing.extend(failures_of(&step.name, &report.output));
    }
    println!("  {mark} {}: {passed} passed, {failed} failed, {}", step.name, progress::elapsed(started.elapsed()));
    report.counts
}

/// A line for each test that a failed step names, or for the step where it names none: what did not compile, say.
fn failures_of(step: &str, output: &str) -> Vec<String> {
    let named = counts::failing(output);
    if named.is_empty() { vec![step.to_owned()] } else { named.iter().map(|test| format!("{step}: {test}")).collect() }
}
