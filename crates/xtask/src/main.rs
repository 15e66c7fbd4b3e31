//! Tasks of the workspace; `cargo xtask help` lists them.

mod assets;
mod bench;
mod need;
mod page;
mod passed;
mod places;
mod python;
mod report;
mod run;
mod rust;
mod setup;
mod steps;
mod system;
mod test;

use anyhow::{Result, anyhow};
use std::process::ExitCode;

/// Name, help and function of a task.
type Task = (&'static str, &'static str, fn(&[&str]) -> Result<()>);

const TASKS: [Task; 13] = [
    ("setup", "install missing tools, networks and packages", setup::run),
    ("serve", "build the page and serve it on 127.0.0.1:8080 or the next free port", page::serve),
    ("dist", "build the page into dist/ and print its sizes", page::dist),
    ("reproduce", "rebuild the page from scratch in another folder and compare it with dist/", page::reproduce),
    ("npm", "build and pack the npm package in target/npm", page::npm),
    ("networks", "download the face networks, which the command line includes", assets::only_networks),
    ("test", "[--all] [STEP…] run the gate, everything, or the named steps", test::run),
    ("deny", "check licences, bans and sources of dependencies against deny.toml", rust::deny),
    (
        "bench",
        "[PART…] run benchmarks and write docs/benchmarks.json; parts: native, solvers, batches, browser",
        bench::run,
    ),
    ("screenshots", "render the documentation's pictures", page::screenshots),
    ("wheel", "build the Python package in target/wheels and try it in an empty environment", python::wheel),
    ("site", "build the documentation site in target/site", page::site),
    ("help", "print this help", help),
];

const NOTES: &str = "
Each task installs what it needs. Tools go to $XDG_CACHE_HOME/rosto (default: ~/.cache/rosto), which all checkouts share.
On Debian, missing system packages are installed with apt-get.

  ROSTO_BROWSER         Chromium or Chrome for the tests; default: the newest of the system
  CHROMEDRIVER          ChromeDriver of the same version
  ROSTO_OLDEST_BROWSER  Chromium for the step `oldest`; default: the oldest that Debian offers
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (name, rest) = words.split_first().map_or(("help", &[][..]), |(name, rest)| (*name, rest));
    let name = if matches!(name, "-h" | "--help") { "help" } else { name };
    let task = TASKS.iter().find(|(task, ..)| *task == name);
    let unknown = || anyhow!("unknown task `{name}`; `cargo xtask help` lists the tasks");
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
