//! What is known of the workspace, in a form in which a breach can be planted.

use std::collections::BTreeMap;

use crate::graph::{self, Graph};
use crate::sources::{self, Source};

/// Who depends on whom, and what stands in the sources.
#[derive(Clone)]
pub struct Facts {
    /// What the manifests declare, for all targets.
    pub declared: Graph,
    /// What a build for this machine resolves to.
    pub host: Graph,
    /// What a build for wasm32 resolves to.
    pub wasm: Graph,
    /// What the page's two modules take in, each with its own features.
    pub modules: BTreeMap<&'static str, Vec<String>>,
    /// The sources of every package of ours, without comments and tests.
    pub sources: BTreeMap<String, Vec<Source>>,
}

impl Facts {
    /// As cargo and the disk tell them.
    pub fn of_workspace() -> Self {
        let declared = Graph::of_workspace();
        let modules = ["rosto-studio-web", "rosto-studio-webgl"];
        let built = modules.map(|package| (package, graph::built_for_wasm(package).into_iter().collect()));
        let sources = declared.members().into_iter().map(|package| (package.clone(), sources::of(&package))).collect();
        Self { declared, host: Graph::of_host(), wasm: Graph::of_wasm(), modules: built.into(), sources }
    }

    /// Where one of these words stands in the sources of one of these packages.
    pub fn words(&self, packages: &[&str], words: &[&str]) -> Vec<String> {
        let lines = packages.iter().flat_map(|package| self.sources[*package].iter());
        lines.filter(|line| words.iter().any(|word| line.code.contains(word))).map(Source::to_string).collect()
    }

    /// Plants a line in the sources of a package.
    pub fn write(&mut self, package: &str, code: &str) {
        let line = Source { place: format!("{package}, planted"), code: code.to_owned() };
        self.sources.get_mut(package).unwrap().push(line);
    }

    /// Plants a line in a file of a package.
    pub fn write_beside(&mut self, package: &str, file: &str, code: &str) {
        let lines = self.sources.get_mut(package).unwrap();
        let place = lines.iter().find(|line| line.place.contains(file)).unwrap().place.clone();
        lines.push(Source { place, code: code.to_owned() });
    }

    /// Plants a dependency, in every graph.
    pub fn depend(&mut self, package: &str, on: &str) {
        for graph in [&mut self.declared, &mut self.host, &mut self.wasm] {
            graph.add(package, on);
        }
    }
}
