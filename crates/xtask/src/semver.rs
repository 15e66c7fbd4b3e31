//! `cargo xtask semver`: whether the published crates' versions say what has changed since the last release.

use crate::failure::{Failure, Result};
use crate::process::Run;
use crate::{crates, tools, workspace};
use std::process::ExitCode;
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(3600);
/// How releases are tagged; see `.github/workflows/release.yml`.
const RELEASES: &str = "v[0-9]*";

/// Compares the crates with the last release before this commit.
pub fn run() -> Result<ExitCode> {
    let Some(baseline) = baseline(&tags()?, &tags_here()?) else {
        println!("No release is tagged before this commit: there is nothing to compare with.");
        return Ok(ExitCode::SUCCESS);
    };
    println!("Comparing with {baseline}.");
    let program = tools::cargo_semver_checks().obtain()?.join("cargo-semver-checks");
    let check = Run::new(program).args(arguments(&baseline)).env("CARGO_TERM_COLOR", "never");
    let ended = check.current_dir(workspace::root()).within(LIMIT).run()?;
    print!("{}", ended.output);
    if ended.success {
        return Ok(ExitCode::SUCCESS);
    }
    let why = ended.given_up.unwrap_or_else(|| format!("a version does not say what has changed since {baseline}"));
    Err(Failure::new(why).advice("raise `version` in Cargo.toml as cargo-semver-checks says above"))
}

fn arguments(baseline: &str) -> Vec<&str> {
    let common = ["semver-checks", "--baseline-rev", baseline];
    common.into_iter().chain(crates::packages()).collect()
}

/// Of the newest first, the first that is not this commit's own.
fn baseline(newest_first: &str, here: &str) -> Option<String> {
    let is_here = |tag: &&str| here.lines().any(|own| own == *tag);
    newest_first.lines().find(|tag| !is_here(tag)).map(str::to_owned)
}

/// The releases that led to this commit, newest first.
fn tags() -> Result<String> {
    git(&["tag", "--list", RELEASES, "--merged", "HEAD", "--sort=-version:refname"])
}

/// This commit's own: while a release is made, its tag is there already.
fn tags_here() -> Result<String> {
    git(&["tag", "--list", RELEASES, "--points-at", "HEAD"])
}

fn git(arguments: &[&str]) -> Result<String> {
    Run::new("git").args(arguments).current_dir(workspace::root()).quietly()?.checked()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_release_there_is_nothing_to_compare_with() {
        assert_eq!(baseline("", ""), None);
        assert_eq!(baseline("v0.1.0\n", "v0.1.0\n"), None);
    }

    #[test]
    fn the_last_release_but_this_one_is_compared_with() {
        assert_eq!(baseline("v0.2.0\nv0.1.0\n", "v0.2.0\n").as_deref(), Some("v0.1.0"));
        assert_eq!(baseline("v0.2.0\nv0.1.0\n", "").as_deref(), Some("v0.2.0"));
    }

    #[test]
    fn every_published_crate_is_compared() {
        let arguments = arguments("v0.1.0");
        assert_eq!(arguments[..3], ["semver-checks", "--baseline-rev", "v0.1.0"]);
        assert_eq!(arguments.len(), 3 + 2 * crates::PUBLISHED.len());
        assert!(arguments.windows(2).any(|pair| pair == ["--package", "rosto-mesh"]));
    }
}
