//! Builds the page once more, from nothing and in another folder, and compares it with `dist/` byte for byte.

use crate::failure::{Doing, Failure, Result};
use crate::process::Run;
use crate::{cache, dist, progress, setup, size, workspace};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

const BUILD_LIMIT: Duration = Duration::from_secs(7200);
/// Trunk's own, of no content, and never published.
const LOCK: &str = ".trunk-lock";

/// The SHA-256 of every file by its path below the page.
type Hashes = BTreeMap<String, String>;

/// Builds `dist/` if anything has changed, builds it elsewhere, and prints the hashes of both.
pub fn run() -> Result<ExitCode> {
    let started = Instant::now();
    dist::build(&setup::for_page()?)?;
    let here = hashes(&workspace::dist())?;
    println!("Building the page again from nothing, in another folder; this takes some minutes.");
    let elsewhere = cache::folder()?.join(format!("another-checkout-{}", std::process::id()));
    let there = build_in(&elsewhere).and_then(|()| hashes(&elsewhere.join("dist")));
    cache::remove_folder(&elsewhere)?;
    let there = there?;
    println!("{}", table(&here, &there));
    println!("{} files, {}", here.len(), progress::elapsed(started.elapsed()));
    if here == there {
        return Ok(ExitCode::SUCCESS);
    }
    Err(Failure::new("two builds of the same sources differ").advice("look at the files marked ✗ above"))
}

/// A checkout has what git knows and what it would take, and nothing that was built.
fn build_in(folder: &Path) -> Result {
    let listed = Run::new("git").args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    let listed = listed.current_dir(workspace::root()).quietly()?.checked()?;
    for name in listed.split_terminator('\0').filter(|name| workspace::root().join(name).is_file()) {
        cache::copy(&workspace::root().join(name), &folder.join(name))?;
    }
    let build = Run::new("cargo").args(["xtask", "dist"]).current_dir(folder).within(BUILD_LIMIT);
    // The folder for what is built would be the same one, and cargo's toolchain is to be found anew.
    build.without_env("CARGO_TARGET_DIR").without_env("CARGO").run()?.checked().map(drop)
}

fn hashes(dist: &Path) -> Result<Hashes> {
    let named = |file: PathBuf| {
        let name = file.strip_prefix(dist).doing("naming a file of the page")?.to_string_lossy().replace('\\', "/");
        Ok((name, cache::sha256_of(&file)?))
    };
    let all = size::files_below(dist)?.into_iter().map(named).collect::<Result<Hashes>>()?;
    Ok(all.into_iter().filter(|(name, _)| name != LOCK).collect())
}

/// A line for each file of either, as `sha256sum` writes it; what differs is marked, with both hashes.
fn table(here: &Hashes, there: &Hashes) -> String {
    let names: std::collections::BTreeSet<&String> = here.keys().chain(there.keys()).collect();
    let lines = names.into_iter().map(|name| match (here.get(name), there.get(name)) {
        (Some(one), Some(other)) if one == other => format!("{one}  {name}"),
        (one, other) => {
            let [one, other] = [one, other].map(|hash| hash.map_or("missing", String::as_str));
            format!("✗ {one} here, {other} there  {name}")
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(files: &[(&str, &str)]) -> Hashes {
        files.iter().map(|(name, hash)| ((*name).to_owned(), (*hash).to_owned())).collect()
    }

    #[test]
    fn what_differs_or_is_missing_is_marked_and_what_is_the_same_is_not() {
        let here = of(&[("a", "1"), ("b", "2"), ("c", "3")]);
        let there = of(&[("a", "1"), ("b", "9"), ("d", "4")]);
        let expected = "1  a\n✗ 2 here, 9 there  b\n✗ 3 here, missing there  c\n✗ missing here, 4 there  d";
        assert_eq!(table(&here, &there), expected);
    }
}
