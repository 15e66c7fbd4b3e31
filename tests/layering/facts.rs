//! Dependencies and sources of the workspace, in a form that a test can plant breaches in.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Direct dependencies by package, without development and build dependencies.
pub type Graph = BTreeMap<String, BTreeSet<String>>;

/// The input of the invariants' checks.
#[derive(Clone)]
pub struct Facts {
    /// Dependencies that each workspace package declares, for all targets.
    pub declared: Graph,
    /// Dependencies of each package in a build for the host.
    pub host: Graph,
    /// The same for wasm32.
    pub wasm: Graph,
    /// Packages in each of the page's two modules, with that module's features.
    pub modules: BTreeMap<&'static str, BTreeSet<String>>,
    /// Lines of each workspace package as location and code, without comments and tests.
    pub sources: BTreeMap<String, Vec<(String, String)>>,
}

impl Facts {
    /// Runs cargo and reads the sources.
    pub fn of_workspace() -> Self {
        let metadata = metadata(&["--no-deps"]);
        let packages = || list(&metadata["packages"]).map(|package| (text(&package["name"]), package));
        let modules = ["rosto-studio-web", "rosto-studio-webgl"].map(|package| (package, built_for_wasm(package)));
        let declared = packages().map(|(name, package)| (name, declared(package))).collect();
        let sources = packages().map(|(name, package)| (name, sources(package))).collect();
        let optional: Vec<_> = packages().map(|(name, package)| (name, optional(package))).collect();
        let enabling: Vec<_> = packages().flat_map(|(name, package)| enabling(&name, package)).collect();
        let [host, wasm] = ["host-tuple", "wasm32-unknown-unknown"].map(|target| {
            let mut graph = resolved(target);
            move_optional(&mut graph, &optional, &enabling);
            graph
        });
        Self { declared, host, wasm, modules: modules.into(), sources }
    }

    /// Lines of these packages that contain one of these words.
    pub fn words<'a>(&self, packages: impl IntoIterator<Item = &'a str>, words: &[&str]) -> Vec<String> {
        let lines = packages.into_iter().flat_map(|package| &self.sources[package]);
        let found = lines.filter(|(_, code)| words.iter().any(|word| code.contains(word)));
        found.map(|(place, code)| format!("{place}: {}", code.trim())).collect()
    }

    /// Plants a line in a file of a package.
    pub fn write(&mut self, package: &str, file: &str, code: &str) {
        let lines = self.sources.get_mut(package).unwrap();
        let place = lines.iter().find(|(place, _)| place.contains(file)).unwrap().0.clone();
        lines.push((place, code.to_owned()));
    }

    /// Plants a dependency in every graph.
    pub fn depend(&mut self, package: &str, on: &str) {
        for graph in [&mut self.declared, &mut self.host, &mut self.wasm] {
            graph.get_mut(package).unwrap().insert(on.to_owned());
        }
    }
}

/// Packages that a package depends on, directly or transitively.
pub fn reachable(graph: &Graph, package: &str) -> BTreeSet<String> {
    let mut reached = graph[package].clone();
    let mut waiting: Vec<String> = reached.iter().cloned().collect();
    while let Some(next) = waiting.pop() {
        let further = graph.get(&next).into_iter().flatten();
        waiting.extend(further.filter(|name| reached.insert((*name).clone())).cloned().collect::<Vec<_>>());
    }
    reached
}

fn declared(package: &Value) -> BTreeSet<String> {
    list(&package["dependencies"]).filter(ships).map(|dependency| text(&dependency["name"])).collect()
}

/// Dependencies of a package that only its features enable.
fn optional(package: &Value) -> BTreeSet<String> {
    let dependencies = list(&package["dependencies"]).filter(ships).filter(|dependency| dependency["optional"] == true);
    dependencies.map(|dependency| text(&dependency["name"])).collect()
}

/// A package with each dependency of which it enables features.
fn enabling(name: &str, package: &Value) -> Vec<(String, String)> {
    let enables = |dependency: &&Value| {
        dependency["uses_default_features"] == true || list(&dependency["features"]).next().is_some()
    };
    let dependencies = list(&package["dependencies"]).filter(ships).filter(enables);
    dependencies.map(|dependency| (name.to_owned(), text(&dependency["name"]))).collect()
}

/// Attributes optional dependencies of workspace packages to the packages that enable them: cargo resolves the workspace
/// with the features of all its packages.
fn move_optional(graph: &mut Graph, optional: &[(String, BTreeSet<String>)], enabling: &[(String, String)]) {
    for (package, dependencies) in optional {
        let Some(resolved) = graph.get_mut(package) else { continue };
        let moved: Vec<String> = dependencies.iter().filter(|name| resolved.remove(*name)).cloned().collect();
        for (user, _) in enabling.iter().filter(|(_, used)| used == package) {
            graph.entry(user.clone()).or_default().extend(moved.iter().cloned());
        }
    }
}

fn resolved(target: &str) -> Graph {
    let metadata = metadata(&["--filter-platform", target]);
    let named = |package: &Value| (text(&package["id"]), text(&package["name"]));
    let names: BTreeMap<_, _> = list(&metadata["packages"]).map(named).collect();
    let mut graph = Graph::new();
    for node in list(&metadata["resolve"]["nodes"]) {
        let direct = list(&node["deps"]).filter(|dependency| list(&dependency["dep_kinds"]).any(|kind| ships(&kind)));
        // Two versions of a package share an entry, which gets the dependencies of both.
        let all = graph.entry(names[&text(&node["id"])].clone()).or_default();
        all.extend(direct.map(|dependency| names[&text(&dependency["pkg"])].clone()));
    }
    graph
}

/// False for development and build dependencies.
fn ships(dependency: &&Value) -> bool {
    dependency["kind"].is_null()
}

fn built_for_wasm(package: &str) -> BTreeSet<String> {
    let tree = ["tree", "--prefix", "none", "--edges", "normal", "--target", "wasm32-unknown-unknown", "--package"];
    let printed = cargo(&[&tree[..], &[package]].concat());
    printed.lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect()
}

fn metadata(arguments: &[&str]) -> Value {
    serde_json::from_str(&cargo(&[&["metadata", "--format-version", "1"], arguments].concat())).unwrap()
}

fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO")).args(arguments).arg("--locked").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().unwrap().iter()
}

fn text(value: &Value) -> String {
    value.as_str().unwrap().to_owned()
}

/// Rust sources and shaders of a package.
fn sources(package: &Value) -> Vec<(String, String)> {
    // cargo lists the library first.
    let root = text(&package["targets"][0]["src_path"]);
    let folder = Path::new(&root).parent().unwrap();
    let files = [files_below(folder, "rs"), files_below(&folder.with_file_name("shaders"), "wgsl")].concat();
    files.iter().flat_map(|file| lines(file)).collect()
}

fn lines(file: &Path) -> Vec<(String, String)> {
    let text = std::fs::read_to_string(file).unwrap();
    let mut code: Vec<_> = text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//")).collect();
    let is_test =
        |line: &str| ["#[cfg(test)]", "#[cfg(all(test"].iter().any(|test| line.trim_start().starts_with(test));
    while let Some(start) = code.iter().position(|(_, line)| is_test(line)) {
        let item = code[start..].iter().position(|(_, line)| !line.trim_start().starts_with("#["));
        // An item of one line, or a module up to the end of the file.
        let end = item.map(|item| start + item).filter(|&item| code[item].1.ends_with(';'));
        code.drain(start..end.map_or(code.len(), |item| item + 1));
    }
    code.into_iter().map(|(index, line)| (format!("{}:{}", file.display(), index + 1), line.to_owned())).collect()
}

fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let paths = std::fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path());
    let files = paths.flat_map(|path| if path.is_dir() { files_below(&path, ending) } else { vec![path] });
    files.filter(|file| file.extension().is_some_and(|extension| extension == ending)).collect()
}
