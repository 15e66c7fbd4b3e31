//! The three parts of the long run, each a program of its own.

use super::Amounts;
use crate::page;
use crate::places::{assets, root, target};
use crate::run::{Ended, Run};
use crate::setup::Kit;
use crate::steps::command_line;
use anyhow::Result;
use std::time::Duration;

/// A program that tries to break something.
pub struct Part {
    /// Its name in the log.
    pub name: &'static str,
    /// What it does so often.
    pub what: &'static str,
    /// Over its figures.
    pub title: &'static str,
    /// How often.
    pub amount: u64,
    /// Why it cannot be run, if it cannot.
    pub missing: fn() -> Option<&'static str>,
    /// Runs it to its end.
    pub run: fn(&Kit, u64) -> Result<Ended>,
}

const LIMIT: Duration = Duration::from_secs(24 * 3600);

/// Those with something to do.
pub fn chosen(amounts: &Amounts) -> Vec<Part> {
    let all = [
        Part {
            name: "bytes",
            what: "broken files for the readers of photos, GLBs, projects, histories and networks",
            title: "Broken bytes",
            amount: amounts.inputs,
            missing: || None,
            run: bytes,
        },
        Part {
            name: "session",
            what: "random actions on a session without a browser",
            title: "A random visitor of the session",
            amount: amounts.actions,
            missing: || without("crates/session/Cargo.toml", "rosto-session", "there is no crate rosto-session"),
            run: session,
        },
        Part {
            name: "page",
            what: "random actions on the page in headless Chromium, after every journey",
            title: "A restless visitor of the page",
            amount: amounts.page_actions,
            missing: || without("package.json", "\"restless\"", "package.json has no script `restless`"),
            run: page,
        },
    ];
    all.into_iter().filter(|part| part.amount > 0).collect()
}

fn bytes(_: &Kit, inputs: u64) -> Result<Ended> {
    let folder = target().join("torture");
    let cargo = Run::new("cargo").current_dir(root()).args(["run", "--quiet", "--release", "--locked"]);
    let program = cargo.args(["--package", "rosto-cli", "--example", "torture", "--", "--inputs"]);
    let program = program.arg(inputs.to_string()).arg("--assets").arg(assets());
    logged("bytes", program.arg("--folder").arg(folder))
}

fn session(_: &Kit, actions: u64) -> Result<Ended> {
    let cargo = Run::new("cargo").current_dir(root()).args(["test", "--quiet", "--release", "--locked"]);
    let test = cargo.args(["--package", "rosto-session", "random", "--", "--nocapture"]);
    logged("session", test.env("ROSTO_ACTIONS", actions.to_string()))
}

fn page(kit: &Kit, actions: u64) -> Result<Ended> {
    page::build(kit)?;
    let journeys = kit.run("npm").args(["run", "--silent", "journeys", "--", "--all"]);
    let walked = logged("journeys", journeys.env("ROSTO_CLI", command_line()?))?;
    if !walked.success {
        return Ok(walked);
    }
    let npm = kit.run("npm").args(["run", "--silent", "restless", "--", "--actions"]);
    logged("page", npm.arg(actions.to_string()))
}

fn logged(name: &str, run: Run) -> Result<Ended> {
    run.within(LIMIT).log(&format!("torture-{name}")).run()
}

fn without(file: &str, text: &str, missing: &'static str) -> Option<&'static str> {
    let found = std::fs::read_to_string(root().join(file)).is_ok_and(|found| found.contains(text));
    (!found).then_some(missing)
}
