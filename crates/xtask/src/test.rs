//! `cargo xtask test`: runs all steps or the named ones.

use crate::run::{causes, elapsed, last_lines};
use crate::setup::{self, Kit};
use crate::steps::{ALL, Step};
use anyhow::{Result, bail, ensure};
use std::time::Instant;

/// Lines of output shown when a step fails, and again at the end, in case the log is truncated at the start.
const SHOWN_LINES: [usize; 2] = [400, 40];

/// Runs all steps or the named ones, and continues after a failure.
pub fn run(wanted: &[&str]) -> Result<()> {
    let unknown = wanted.iter().find(|name| !ALL.iter().any(|step| step.is_called(name)));
    if let Some(name) = unknown {
        bail!("unknown step `{name}`; the steps are {}", ALL.map(|step| step.name).join(", "));
    }
    let steps = ALL.iter().filter(|step| wanted.is_empty() || wanted.iter().any(|name| step.is_called(name)));
    let kit = setup::for_tests()?;
    let results: Vec<_> = steps.map(|step| (step.name, step.run(&kit))).collect();
    let failed: Vec<&str> = results.iter().filter(|(_, result)| result.is_err()).map(|(name, _)| *name).collect();
    for (name, result) in &results {
        if let Err(output) = result {
            println!("\n✗ {name}\n{}", last_lines(output, SHOWN_LINES[1]));
        }
    }
    kit.report_missing();
    println!("\nsteps: {} passed, {} failed", results.len() - failed.len(), failed.len());
    ensure!(failed.is_empty(), "failed: {}", failed.join(", "));
    Ok(())
}

impl Step {
    /// Whether `name` is this step's name, or the part of it before the colon.
    fn is_called(&self, name: &str) -> bool {
        self.name == name || self.name.split(':').next() == Some(name)
    }

    /// Runs the step; returns its output, on failure as the error.
    fn run(&self, kit: &Kit) -> Result<String, String> {
        println!("▸ {} ({})", self.name, self.what);
        let started = Instant::now();
        let ended = (self.program)(kit).and_then(|program| {
            let program = program.env("CARGO_TERM_COLOR", "never").env("NO_COLOR", "1");
            program.log(&self.name.replace(':', "-")).run()
        });
        let result = match ended {
            Ok(ended) if ended.success => Ok(ended.output),
            Ok(ended) => Err(ended.output),
            Err(error) => Err(causes(&error)),
        };
        let took = elapsed(started.elapsed());
        match &result {
            // Test runners end with such a line; cargo also prints one for each crate without tests.
            Ok(output) => match output.lines().rfind(|line| line.contains("passed") && !line.contains(" 0 passed")) {
                Some(counts) => println!("  ✓ {}, {took}: {}", self.name, counts.trim()),
                None => println!("  ✓ {}, {took}", self.name),
            },
            Err(output) => println!("{}\n  ✗ {}, {took}", last_lines(output, SHOWN_LINES[0]), self.name),
        }
        result
    }
}
