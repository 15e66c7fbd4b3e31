//! Dependency cycles between the modules of a crate.

use crate::facts::{Graph, reachable};
use std::collections::{BTreeMap, BTreeSet};

/// A crate's modules by path, such as `crate::a::b`.
#[derive(Default)]
struct Modules {
    code: BTreeMap<String, String>,
    /// Paths that a module re-exports, by the path that they get there.
    re_exports: BTreeMap<String, Vec<String>>,
}

/// Modules that are part of a cycle, each with the modules that it uses. Uses of an ancestor do not count.
pub fn of(sources: &[(String, String)]) -> Vec<String> {
    let modules = Modules::new(sources);
    let used = |(module, code): (&String, &String)| (module.clone(), modules.used(module, code));
    let uses: Graph = modules.code.iter().map(used).collect();
    let in_cycle = uses.iter().filter(|(module, _)| reachable(&uses, module).contains(*module));
    in_cycle.map(|(module, used)| format!("{module} uses {used:?}")).collect()
}

impl Modules {
    fn new(sources: &[(String, String)]) -> Self {
        let mut modules = Self::default();
        for (place, line) in sources {
            let Some((_, file)) = place.split_once("/src/") else { continue };
            let Some((path, _)) = file.split_once(".rs:") else { continue };
            let path = path.split('/').filter(|name| !["lib", "main", "mod"].contains(name));
            let module = ["crate"].into_iter().chain(path).collect::<Vec<_>>().join("::");
            *modules.code.entry(module).or_default() += &format!("{line}\n");
        }
        for (module, code) in &modules.code {
            let is_re_export = |(at, _): &(usize, &str)| code[..*at].ends_with("pub ") || code[..*at].ends_with(") ");
            let uses = code.match_indices("use ").filter(is_re_export);
            let re_exports = uses.flat_map(|(at, start)| paths(&mut &code[at + start.len()..]));
            // A single name is the module's own macro.
            for path in re_exports.filter(|path| path.len() > 1) {
                modules.re_exports.insert(format!("{module}::{}", path[path.len() - 1]), path);
            }
        }
        modules
    }

    /// The module's children, and the modules that it names by `crate::` and `super::`.
    fn used(&self, module: &str, code: &str) -> BTreeSet<String> {
        let is_child = |other: &&String| other.rsplit_once("::").is_some_and(|(parent, _)| parent == module);
        let starts = ["crate::", "super::"].into_iter().flat_map(|start| code.match_indices(start));
        let starts = starts.filter(|(at, _)| !code[..*at].ends_with([':', '_', '$']));
        let named = starts.flat_map(|(at, _)| paths(&mut &code[at..])).map(|path| self.resolved(module, &path));
        let used = self.code.keys().filter(is_child).cloned().chain(named);
        used.filter(|used| !format!("{module}::").starts_with(&format!("{used}::"))).collect()
    }

    /// The module that defines what a path names.
    fn resolved(&self, from: &str, path: &[String]) -> String {
        let mut at = from.to_owned();
        for (index, name) in path.iter().enumerate() {
            let child = format!("{at}::{name}");
            match name.as_str() {
                "crate" => at = name.clone(),
                "super" => at.truncate(at.rfind("::").unwrap_or(at.len())),
                "self" => {}
                _ if self.code.contains_key(&child) => at = child,
                _ => match self.re_exports.get(&child) {
                    Some(target) => return self.resolved(&at, &[target, &path[index + 1..]].concat()),
                    None => return at,
                },
            }
        }
        at
    }
}

/// The paths of the use tree, such as `crate::a::{B, c::D}`, at the start of `text`; advances `text` past it.
fn paths(text: &mut &str) -> Vec<Vec<String>> {
    if !text.starts_with('{') {
        let is_of_name = |letter: char| letter.is_alphanumeric() || letter == '_';
        let end = text.find(|letter: char| !is_of_name(letter)).unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        let begins_path = |text: &&str| text.starts_with(|letter: char| letter == '{' || is_of_name(letter));
        let further = rest.strip_prefix("::").filter(begins_path);
        *text = further.unwrap_or(rest);
        let below = further.map_or_else(|| vec![Vec::new()], |_| paths(text));
        return below.into_iter().map(|path| [vec![name.to_owned()], path].concat()).collect();
    }
    let mut branches = Vec::new();
    while let Some(branch) = text.strip_prefix(['{', ',']) {
        *text = branch.trim_start();
        // Trailing comma.
        if !text.starts_with('}') {
            branches.extend(paths(text));
        }
        *text = text.trim_start_matches(|letter: char| letter != ',' && letter != '}');
    }
    *text = text.strip_prefix('}').unwrap_or(text);
    branches
}
