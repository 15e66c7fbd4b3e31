//! Broken bytes for every reader of files that others have written.
//!
//! Valid seeds of each kind are made here, mutated by number and given to the program's own readers, on every core.
//! Whatever panics, is slow, holds much memory or breaks a promise is shrunk and written to a folder, once for each
//! cause. Prints one JSON object a line for each kind, and fails if there is a finding.

mod anatomy;
mod case;
mod findings;
mod json;
mod kinds;
mod mutations;
mod options;
mod readers;
mod run;
#[path = "../seeded.rs"]
mod seeded;
mod seeds;
mod shrink;
mod watch;

use std::process::ExitCode;

use findings::{Failure, Findings};
use kinds::Kind;
use options::{Options, Task};
use run::{Plan, Tallies};
use seeds::Seeds;

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let options = Options::read(std::env::args().skip(1))?;
    std::fs::create_dir_all(&options.folder)?;
    watch::keep_panics();
    let seeds = Seeds::new(&options.assets);
    match options.task {
        Task::Run(plan) => {
            let findings = Findings::new(&options.folder);
            let tallies = run::run(&plan, &seeds, &findings, &options.folder);
            Ok(report(&plan, &tallies, &findings, &seeds))
        }
        Task::Again { seed, kind, number } => Ok(again(&case::Case::new(seed, kind, number, &seeds), &seeds)),
        Task::File { kind, path } => Ok(read(kind, &std::fs::read(path)?, &seeds)),
    }
}

fn report(plan: &Plan, tallies: &Tallies, findings: &Findings, seeds: &Seeds) -> ExitCode {
    let read = Kind::ALL.into_iter().filter(|&kind| tallies[kind as usize].inputs() > 0);
    for kind in read {
        let tally = &tallies[kind as usize];
        println!(
            r#"{{"kind": "{}", "inputs": {}, "accepted": {}, "refused": {}, "failed": {}, "slowest_ms": {:.3}, "most_mb": {:.3}, "found": {}}}"#,
            kind.name(),
            tally.inputs(),
            tally.accepted,
            tally.refused,
            tally.failed,
            tally.slowest(plan, kind, seeds).as_secs_f64() * 1e3,
            tally.peak_bytes as f64 * 1e-6,
            findings.of(kind),
        );
    }
    let all = findings.all();
    for ((kind, cause), found) in &all {
        println!("{kind} {} and {} more: {cause}", found.number, found.inputs - 1);
    }
    if all.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Reads one input of a run again.
fn again(case: &case::Case, seeds: &Seeds) -> ExitCode {
    println!("{}", case.describe());
    read(case.kind, &case.bytes(seeds), seeds)
}

fn read(kind: Kind, bytes: &[u8], seeds: &Seeds) -> ExitCode {
    let seen = watch::observe(|| kind.read(bytes, seeds));
    let failure = Failure::of(kind, bytes, seeds, &seen);
    println!(
        "{} bytes, {:?}, {} bytes held\n{:#?}\n{:?}",
        bytes.len(),
        seen.took,
        seen.peak_bytes,
        seen.outcome,
        failure.is_some()
    );
    if failure.is_none() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
