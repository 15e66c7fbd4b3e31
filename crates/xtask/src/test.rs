//! `cargo xtask test`: runs the gate, everything, or the named steps.

use crate::need::Need;
use crate::passed::Passed;
use crate::report::{Outcome, counts, table};
use crate::run::{causes, elapsed, last_lines};
use crate::setup::{self, Kit};
use crate::steps::{GATE, NIGHT, Step};
use crate::{assets, rust};
use anyhow::{Result, bail, ensure};
use std::thread;
use std::time::{Duration, Instant};

/// Lines of output shown when a step fails, and again at the end, in case the log is truncated at the start.
const SHOWN_LINES: [usize; 2] = [400, 40];

/// Runs the gate, with `--all` everything that has not passed on the present files, or the named steps. Continues after
/// a failure.
pub fn run(wanted: &[&str]) -> Result<()> {
    let started = Instant::now();
    let steps = chosen(wanted)?;
    let mut passed = Passed::read();
    let is_known = |step: &&Step| wanted == ["--all"] && passed.contains(step.name);
    let (known, due): (Vec<&Step>, Vec<&Step>) = steps.into_iter().partition(is_known);
    let mut outcomes: Vec<_> = known.iter().map(|step| Outcome::passed(step.name, None)).collect();
    let kit = perform(&due, |outcome| {
        if outcome.output.is_ok() {
            passed.add(outcome.step)?;
        }
        outcomes.push(outcome);
        Ok(())
    })?;
    report(&outcomes, started.elapsed());
    kit.report_missing();
    let failed: Vec<&str> =
        outcomes.iter().filter(|outcome| outcome.output.is_err()).map(|outcome| outcome.step).collect();
    println!("\nsteps: {} passed, {} failed", outcomes.len() - failed.len(), failed.len());
    ensure!(failed.is_empty(), "failed: {}", failed.join(", "));
    Ok(())
}

fn chosen(wanted: &[&str]) -> Result<Vec<&'static Step>> {
    let all = || GATE.iter().chain(&NIGHT);
    match wanted {
        [] => Ok(GATE.iter().collect()),
        ["--all"] => Ok(all().collect()),
        names => {
            if let Some(name) = names.iter().find(|name| !all().any(|step| step.is_called(name))) {
                let known: Vec<&str> = all().map(|step| step.name).collect();
                bail!("unknown step `{name}`; the steps are {}", known.join(", "));
            }
            Ok(all().filter(|step| names.iter().any(|name| step.is_called(name))).collect())
        }
    }
}

/// Runs steps in order, the early ones during the set-up. Returns the kit, which knows what could not be installed.
fn perform(steps: &[&Step], mut done: impl FnMut(Outcome) -> Result<()>) -> Result<Kit> {
    let started = Instant::now();
    let (early, others): (Vec<&Step>, Vec<&Step>) = steps.iter().partition(|step| step.is_early);
    let needs: Vec<Need> = steps.iter().flat_map(|step| step.needs).copied().collect();
    rust::components()?;
    // Without needs, npm packages suffice.
    let files = if needs.is_empty() { assets::npm } else { assets::obtain };
    let kit = thread::scope(|scope| -> Result<Kit> {
        let kit = scope.spawn(|| if others.is_empty() { Ok(Kit::default()) } else { setup::obtain(&needs) });
        files()?;
        for step in early {
            done(step.run(&Kit::default()))?;
        }
        kit.join().expect("invariant: setting up does not panic")
    })?;
    done(Outcome::passed("set-up", Some(started.elapsed())))?;
    for step in others {
        done(step.run(&kit))?;
    }
    Ok(kit)
}

/// Prints the table, and the last lines of each failure.
fn report(outcomes: &[Outcome], total: Duration) {
    for Outcome { step, output, .. } in outcomes {
        if let Err(output) = output {
            println!("\n✗ {step}\n{}", last_lines(output, SHOWN_LINES[1]));
        }
    }
    println!("\n{}", table(outcomes, total));
}

impl Step {
    /// Runs the step.
    fn run(&self, kit: &Kit) -> Outcome {
        println!("▸ {} ({})", self.name, self.what);
        let started = Instant::now();
        let ended = (self.program)(kit).and_then(|program| {
            let program = program.env("CARGO_TERM_COLOR", "never").env("NO_COLOR", "1");
            program.log(&self.name.replace(':', "-")).run()
        });
        let output = match ended {
            Ok(ended) if ended.success => Ok(ended.output),
            Ok(ended) => Err(ended.output),
            Err(error) => Err(causes(&error)),
        };
        let took = started.elapsed();
        match &output {
            Ok(output) => match counts(output) {
                Some(counts) => println!("  ✓ {}, {}: {counts}", self.name, elapsed(took)),
                None => println!("  ✓ {}, {}", self.name, elapsed(took)),
            },
            Err(output) => println!("{}\n  ✗ {}, {}", last_lines(output, SHOWN_LINES[0]), self.name, elapsed(took)),
        }
        Outcome { step: self.name, took: Some(took), output }
    }
}
