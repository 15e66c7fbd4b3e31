//! The npm packages of `package-lock.json`: the published networks, and what the page is tested with.

use crate::failure::{Doing, Failure, Result};
use crate::process::{Run, find_program};
use crate::{progress, workspace};
use serde_json::Value;
use std::path::PathBuf;
use std::time::{Duration, Instant};

const LIMIT: Duration = Duration::from_secs(900);
const OLDEST_NODE: u32 = 20;

/// `node_modules`, as `package-lock.json` says.
pub fn obtain() -> Result<PathBuf> {
    let folder = workspace::root().join("node_modules");
    check_node()?;
    let lock =
        std::fs::read_to_string(workspace::root().join("package-lock.json")).doing("reading package-lock.json")?;
    let installed = std::fs::read_to_string(folder.join(".package-lock.json")).unwrap_or_default();
    if is_installed(&lock, &installed) {
        return Ok(folder);
    }
    progress::announce("npm packages", "the published networks, the type checker, the linter and the page's tests");
    let started = Instant::now();
    let install = Run::new("npm").args(["ci", "--no-audit", "--no-fund"]).current_dir(workspace::root());
    install.within(LIMIT).run()?.checked().map_err(|cause| {
        let failure = Failure::new("the npm packages could not be installed").because(&cause);
        failure.advice("check that npm can reach its package registry, then run the command again")
    })?;
    progress::done("npm packages", started);
    Ok(folder)
}

/// The folder with the packages' programs.
pub fn programs() -> PathBuf {
    workspace::root().join("node_modules").join(".bin")
}

fn check_node() -> Result {
    let advice = format!("install Node.js {OLDEST_NODE} or later, with npm");
    for program in ["node", "npm"] {
        if find_program(program).is_none() {
            return Err(Failure::new(format!("the program `{program}` is not on this machine")).advice(advice));
        }
    }
    let printed = Run::new("node").arg("--version").quietly()?.checked()?;
    match major_version(&printed) {
        Some(major) if major >= OLDEST_NODE => Ok(()),
        _ => Err(Failure::new(format!("Node.js {} is too old", printed.trim())).advice(advice)),
    }
}

fn major_version(printed: &str) -> Option<u32> {
    printed.trim().strip_prefix('v')?.split('.').next()?.parse().ok()
}

/// Whether npm's note of what it installed holds every package of the lock file, in the same version.
fn is_installed(lock: &str, installed: &str) -> bool {
    let (Some(wanted), Some(present)) = (packages(lock), packages(installed)) else { return false };
    wanted.iter().filter(|(path, _)| !path.is_empty()).all(|(path, package)| match present.get(path) {
        Some(found) => found["version"] == package["version"] && found["integrity"] == package["integrity"],
        // Packages for other systems are not installed here.
        None => package["optional"] == Value::Bool(true),
    })
}

fn packages(lock: &str) -> Option<serde_json::Map<String, Value>> {
    let lock: Value = serde_json::from_str(lock).ok()?;
    lock["packages"].as_object().cloned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOCK: &str = r#"{"packages": {"": {}, "node_modules/a": {"version": "1.0.0", "integrity": "x"},
        "node_modules/b": {"version": "2.0.0", "optional": true}}}"#;

    #[test]
    fn an_optional_package_may_be_absent() {
        let installed = r#"{"packages": {"node_modules/a": {"version": "1.0.0", "integrity": "x"}}}"#;
        assert!(is_installed(LOCK, installed));
    }

    #[test]
    fn another_version_or_nothing_means_install() {
        assert!(!is_installed(LOCK, r#"{"packages": {"node_modules/a": {"version": "1.0.1"}}}"#));
        assert!(!is_installed(LOCK, r#"{"packages": {}}"#));
        assert!(!is_installed(LOCK, ""));
    }

    #[test]
    fn reads_the_major_version_of_node() {
        assert_eq!(major_version("v20.20.2\n"), Some(20));
        assert_eq!(major_version("node"), None);
    }
}
