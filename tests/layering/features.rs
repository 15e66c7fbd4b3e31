//! Equal features of the dependencies that the page's module and the worker's have in common: a build shares them.

use std::collections::BTreeMap;
use std::process::Command;

#[test]
fn the_page_and_the_worker_share_their_dependencies() {
    let [page, worker] = ["rosto-studio-web", "rosto-vision-web"].map(features);
    let differs =
        |(package, features): &(&String, &String)| worker.get(*package).is_some_and(|other| other != *features);
    let differing: Vec<&str> =
        page.iter().filter(differs).filter_map(|(package, _)| package.split(' ').next()).collect();
    assert_eq!(differing, ["rosto"], "only the worker's library finds faces");
}

/// Features of a module's dependencies, by name and version.
fn features(package: &str) -> BTreeMap<String, String> {
    let words = "tree --locked --target wasm32-unknown-unknown --edges normal --prefix none --format {p}|{f}";
    let cargo = Command::new(env!("CARGO")).args(words.split(' ')).args(["--package", package]).output().unwrap();
    assert!(cargo.status.success(), "{}", String::from_utf8_lossy(&cargo.stderr));
    let lines = String::from_utf8(cargo.stdout).unwrap();
    let pairs = lines.lines().filter_map(|line| line.trim_end_matches(" (*)").split_once('|'));
    pairs.map(|(package, features)| (package.to_owned(), features.to_owned())).collect()
}
