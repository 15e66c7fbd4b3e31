//! The workspace's tasks: `cargo xtask setup`, `serve`, `dist`, `reproduce`, `npm`, `test`, `deny`, `semver`, `bench`,
//! `readers`, `torture`, `screenshots`, `wheel`, `site`.

mod apt;
mod bench;
mod browser;
mod cache;
mod crates;
mod debian;
mod deny;
mod dist;
mod failure;
mod figures;
mod help;
mod machine;
mod networks;
mod npm;
mod package;
mod paths;
mod portrait;
mod process;
mod progress;
mod python;
mod readers;
mod reproduce;
mod screenshots;
mod semver;
mod serve;
mod setup;
mod site;
mod size;
mod test;
mod toolchain;
mod tools;
mod torture;
mod versions;
mod wheel;
mod workspace;

use failure::{Failure, Result};
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(code) => code,
        Err(failure) => {
            eprintln!("\n✗ {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<ExitCode> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["setup"] => set_up(),
        ["serve"] => serve::run(),
        ["dist"] => dist::run(),
        ["reproduce"] => reproduce::run(),
        ["npm"] => package::run(),
        ["test", steps @ ..] => test::run(steps),
        ["deny"] => deny::run(),
        ["semver"] => semver::run(),
        ["bench", parts @ ..] => bench::run(parts),
        ["readers"] => readers::run(),
        ["torture", arguments @ ..] => torture::run(arguments),
        ["screenshots"] => screenshots::run(),
        ["wheel"] => wheel::run(),
        ["site"] => site::run(),
        [] | ["help" | "-h" | "--help"] => {
            print!("{}", help::TEXT);
            Ok(ExitCode::SUCCESS)
        }
        unknown => {
            let failure = Failure::new(format!("`{}` is no task", unknown.join(" ")));
            Err(failure.advice("cargo xtask help lists the tasks"))
        }
    }
}

fn set_up() -> Result<ExitCode> {
    let started = Instant::now();
    setup::for_tests()?;
    println!("Everything is in place ({}).", progress::elapsed(started.elapsed()));
    Ok(ExitCode::SUCCESS)
}
