//! Debian packages: the only way in which set-up touches the system, and only for what is missing.

use crate::failure::{Failure, Result};
use crate::process::{Run, find_program};
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(900);
const LOCK_WAIT: &str = "DPkg::Lock::Timeout=120";

/// Installs packages with apt-get, as root or through `sudo -n`.
pub fn install(packages: &[&str]) -> Result {
    let by_hand = format!("install them yourself: apt-get install {}", packages.join(" "));
    if find_program("apt-get").is_none() {
        return Err(Failure::new("this machine has no apt-get").advice(by_hand));
    }
    let first = apt_get("install", packages).and_then(|ended| ended.checked());
    let Err(first) = first else { return Ok(()) };
    // Package lists may be missing or old: fetch them once and try again.
    let second =
        apt_get("update", &[]).and_then(|ended| ended.checked()).and_then(|_| apt_get("install", packages)?.checked());
    second.map(|_| ()).map_err(|second| {
        Failure::new(format!("Debian's packages {} could not be installed", packages.join(", ")))
            .because(&first)
            .because(&second)
            .advice(by_hand)
    })
}

fn apt_get(verb: &str, packages: &[&str]) -> Result<crate::process::Ended> {
    let sudo = (!is_root()).then_some("sudo");
    let run = match sudo {
        // -n: a password prompt in the middle of a set-up would look like a hang.
        Some(sudo) => Run::new(sudo).args(["-n", "env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]),
        None => Run::new("apt-get").env("DEBIAN_FRONTEND", "noninteractive"),
    };
    let options = ["-y", "-o", LOCK_WAIT, "--no-install-recommends"];
    run.arg(verb).args(options).args(packages).within(LIMIT).run()
}

fn is_root() -> bool {
    Run::new("id").arg("-u").quietly().is_ok_and(|ended| ended.output.trim() == "0")
}
