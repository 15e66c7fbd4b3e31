//! The workspace's tasks: see `cargo xtask help`.

mod assets;
mod bench;
mod page;
mod places;
mod python;
mod readers;
mod run;
mod rust;
mod setup;
mod steps;
mod system;
mod test;
mod torture;

use anyhow::{Result, anyhow};
use std::process::ExitCode;

/// A task by its name, with its help.
type Task = (&'static str, &'static str, fn(&[&str]) -> Result<()>);

const TASKS: [Task; 14] = [
    ("setup", "obtain all that the tasks below need and that is missing", setup::run),
    ("serve", "build the page and serve it on 127.0.0.1:8080, or the next free port", page::serve),
    ("dist", "build the page for the web into dist/, and show its sizes", page::dist),
    (
        "reproduce",
        "build the page once more, from nothing and elsewhere: it must be dist/ byte for byte",
        page::reproduce,
    ),
    ("npm", "build the npm package out of the page into target/npm, and pack it", page::npm),
    ("test", "[STEP…] check and test everything, or only the named steps", test::run),
    ("deny", "check licences, bans and sources of all that is compiled against deny.toml", rust::deny),
    (
        "bench",
        "[PART…] measure Rosto and its peers into docs/benchmarks.json: native, solvers, batches, browser",
        bench::run,
    ),
    ("readers", "open every file in programs that are not ours, Blender included", readers::run),
    (
        "torture",
        "[MINUTES] fuzz, then run property, browser and monkey tests at length; 10 minutes a part by default",
        torture::run,
    ),
    ("screenshots", "draw the documentation's pictures", page::screenshots),
    ("wheel", "build the Python package into target/wheels, and try it in an empty environment", python::wheel),
    ("site", "build the documentation as a static site into target/site", page::site),
    ("help", "this text", help),
];

const NOTES: &str = "
Every task first obtains what it needs. Tools go to $XDG_CACHE_HOME/rosto (by default ~/.cache/rosto) and are shared by
all checkouts; nothing is fetched or built twice. Debian packages are installed only where something is missing.

  ROSTO_BROWSER  the Chromium or Chrome that the tests drive
  CHROMEDRIVER   its driver
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (name, rest) = words.split_first().map_or(("help", &[][..]), |(name, rest)| (*name, rest));
    let name = if matches!(name, "-h" | "--help") { "help" } else { name };
    let task = TASKS.iter().find(|(task, ..)| *task == name);
    let unknown = || anyhow!("`{name}` is not a task: cargo xtask help lists them");
    match task.ok_or_else(unknown).and_then(|(.., run)| run(rest)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("\n✗ {}", run::causes(&error));
            ExitCode::FAILURE
        }
    }
}

fn help(_: &[&str]) -> Result<()> {
    println!("cargo xtask TASK\n");
    TASKS.iter().for_each(|(name, what, _)| println!("  {name:<12} {what}"));
    print!("{NOTES}");
    Ok(())
}
