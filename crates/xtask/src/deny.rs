//! `cargo xtask deny`: whether all that is compiled may be, by its licence, its source and the bans of `deny.toml`.
//!
//! Security advisories are not among the checks here: their database is fetched anew each time, and what it says
//! changes while the sources stay as they are.

use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::{tools, workspace};
use std::process::ExitCode;
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(600);
const CHECKS: [&str; 3] = ["licenses", "bans", "sources"];

/// Checks every crate in `Cargo.lock`; a warning fails, too.
pub fn run() -> Result<ExitCode> {
    let program = tools::cargo_deny().obtain()?.join("cargo-deny");
    let deny = Run::new(program).args(["--locked", "--color", "never", "check", "--deny", "warnings"]).args(CHECKS);
    let ended = deny.current_dir(workspace::root()).within(LIMIT).run()?;
    print!("{}", ended.output);
    if ended.success {
        return Ok(ExitCode::SUCCESS);
    }
    let why = ended.given_up.unwrap_or_else(|| "a crate is not as deny.toml wants it".to_owned());
    Err(Failure::new(why).advice("see what cargo-deny says above"))
}
