//! Who depends on whom, as cargo resolves it. Only what is shipped counts: no development or build dependencies.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

/// The packages and their direct dependencies.
#[derive(Clone)]
pub struct Graph {
    members: BTreeSet<String>,
    dependencies: BTreeMap<String, BTreeSet<String>>,
}

impl Graph {
    /// What the manifests of the workspace declare, for all targets; knows the members' dependencies only.
    pub fn of_workspace() -> Self {
        let metadata = metadata(&["--no-deps"]);
        let packages = metadata["packages"].as_array().unwrap();
        let dependencies = packages.iter().map(|package| {
            let direct = package["dependencies"].as_array().unwrap().iter();
            let normal = direct.filter(|dependency| dependency["kind"].is_null());
            (text(&package["name"]), normal.map(|dependency| text(&dependency["name"])).collect())
        });
        let dependencies: BTreeMap<_, _> = dependencies.collect();
        Self { members: dependencies.keys().cloned().collect(), dependencies }
    }

    /// All packages of a wasm32 build.
    pub fn of_wasm() -> Self {
        Self::resolved("wasm32-unknown-unknown")
    }

    /// All packages of a build for this machine.
    pub fn of_host() -> Self {
        let printed = Command::new("rustc").arg("-vV").output().unwrap();
        let printed = String::from_utf8(printed.stdout).unwrap();
        let host = printed.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
        Self::resolved(host)
    }

    /// Names of the workspace's packages.
    pub fn members(&self) -> Vec<String> {
        self.members.iter().cloned().collect()
    }

    /// Whether a package belongs to the workspace.
    pub fn is_member(&self, name: &str) -> bool {
        self.members.contains(name)
    }

    /// What a package depends on directly.
    pub fn direct(&self, package: &str) -> Vec<String> {
        let found = self.dependencies.get(package).unwrap_or_else(|| panic!("there is no package {package}"));
        found.iter().cloned().collect()
    }

    /// What a package depends on, directly or not, itself left out.
    pub fn reachable(&self, package: &str) -> BTreeSet<String> {
        let mut reached = BTreeSet::new();
        let mut waiting = self.direct(package);
        while let Some(next) = waiting.pop() {
            if reached.insert(next.clone()) {
                waiting.extend(self.dependencies.get(&next).into_iter().flatten().cloned());
            }
        }
        reached
    }

    /// Plants a dependency.
    pub fn add(&mut self, package: &str, on: &str) {
        self.dependencies.entry(package.to_owned()).or_default().insert(on.to_owned());
        self.dependencies.entry(on.to_owned()).or_default();
    }

    fn resolved(target: &str) -> Self {
        let metadata = metadata(&["--filter-platform", target]);
        let names: BTreeMap<String, String> = metadata["packages"]
            .as_array()
            .unwrap()
            .iter()
            .map(|package| (text(&package["id"]), text(&package["name"])))
            .collect();
        let mut dependencies: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for node in metadata["resolve"]["nodes"].as_array().unwrap() {
            // Two versions of one package are one name here: what either reaches counts.
            let reached = dependencies.entry(names[&text(&node["id"])].clone()).or_default();
            let normal = node["deps"].as_array().unwrap().iter().filter(|dependency| {
                dependency["dep_kinds"].as_array().unwrap().iter().any(|kind| kind["kind"].is_null())
            });
            reached.extend(normal.map(|dependency| names[&text(&dependency["pkg"])].clone()));
        }
        let members = metadata["workspace_members"].as_array().unwrap().iter();
        Self { members: members.map(|id| names[&text(id)].clone()).collect(), dependencies }
    }
}

/// Names of all packages that a wasm32 build of one package takes in, with the features of this build alone.
pub fn built_for_wasm(package: &str) -> BTreeSet<String> {
    let tree = ["tree", "--prefix", "none", "--edges", "normal", "--target", "wasm32-unknown-unknown", "--package"];
    let printed = cargo(&[&tree[..], &[package]].concat());
    printed.lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect()
}

fn metadata(arguments: &[&str]) -> Value {
    serde_json::from_str(&cargo(&[&["metadata", "--format-version", "1"], arguments].concat())).unwrap()
}

/// What a command of cargo's prints about the workspace.
fn cargo(arguments: &[&str]) -> String {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
    let output = Command::new(env!("CARGO")).args(arguments).arg("--manifest-path").arg(manifest).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn text(value: &Value) -> String {
    value.as_str().unwrap().to_owned()
}
