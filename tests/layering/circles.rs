//! Circles of modules inside a crate.

use std::collections::{BTreeMap, BTreeSet};

/// Where a module is in its crate: the root is empty.
type Module = Vec<String>;

/// A crate's modules with their code, and the paths under which they hand on what others hold.
struct Modules {
    code: BTreeMap<Module, String>,
    handed_on: BTreeMap<(Module, String), Vec<String>>,
}

/// The modules of a crate that use each other in a circle, with what of the circle each uses. What a module uses of its
/// ancestors does not count.
pub fn of(sources: &[(String, String)]) -> Vec<String> {
    let modules = Modules::new(sources);
    let used = |(module, code): (&Module, &String)| (module.clone(), modules.used(module, code));
    let mut uses: BTreeMap<Module, BTreeSet<Module>> = modules.code.iter().map(used).collect();
    loop {
        let left: BTreeSet<Module> = uses.keys().cloned().collect();
        uses.values_mut().for_each(|used| used.retain(|module| left.contains(module)));
        let used: BTreeSet<Module> = uses.values().flatten().cloned().collect();
        uses.retain(|module, uses| !uses.is_empty() && used.contains(module));
        if uses.len() == left.len() {
            break;
        }
    }
    let names = |used: &BTreeSet<Module>| used.iter().map(|module| module.join("::")).collect::<Vec<_>>().join(", ");
    uses.iter().map(|(module, used)| format!("{} uses {}", module.join("::"), names(used))).collect()
}

impl Modules {
    fn new(sources: &[(String, String)]) -> Self {
        let mut code: BTreeMap<Module, String> = BTreeMap::new();
        for (place, line) in sources {
            let Some((_, file)) = place.split_once("/src/") else { continue };
            let Some((path, _)) = file.split_once(".rs:") else { continue };
            let path = path.split('/').map(str::to_owned);
            let module = path.filter(|name| !["lib", "main", "mod"].contains(&name.as_str())).collect();
            let lines = code.entry(module).or_default();
            lines.push_str(line);
            lines.push('\n');
        }
        let mut handed_on = BTreeMap::new();
        for (module, code) in &code {
            for path in code
                .match_indices("use ")
                .filter(|(at, _)| code[..*at].ends_with("pub ") || code[..*at].ends_with(") "))
            {
                // A single name is a macro of the module's own.
                for path in paths(&code[path.0 + "use ".len()..]).into_iter().filter(|path| path.len() > 1) {
                    handed_on.insert((module.clone(), path[path.len() - 1].clone()), path);
                }
            }
        }
        Self { code, handed_on }
    }

    /// The module's own children, and what it names by `crate::` and `super::`.
    fn used(&self, module: &Module, code: &str) -> BTreeSet<Module> {
        let children = self.code.keys().filter(|other| other.len() == module.len() + 1 && other.starts_with(module));
        let starts = ["crate::", "super::"].into_iter().flat_map(|start| code.match_indices(start));
        let starts = starts.filter(|(at, _)| !code[..*at].ends_with([':', '_', '$']));
        let named = starts.flat_map(|(at, _)| paths(&code[at..])).map(|path| self.resolved(module, &path));
        children.cloned().chain(named).filter(|used| !module.starts_with(used)).collect()
    }

    /// The module that holds what a path names.
    fn resolved(&self, from: &Module, path: &[String]) -> Module {
        let mut at = from.clone();
        for (index, name) in path.iter().enumerate() {
            let child = [at.as_slice(), std::slice::from_ref(name)].concat();
            match name.as_str() {
                "crate" => at.clear(),
                "super" => drop(at.pop()),
                "self" => {}
                _ if self.code.contains_key(&child) => at = child,
                _ => match self.handed_on.get(&(at.clone(), name.clone())) {
                    Some(held) => return self.resolved(&at, &[held, &path[index + 1..]].concat()),
                    None => return at,
                },
            }
        }
        at
    }
}

/// The paths of a use tree such as `crate::a::{B, c::D}`, with which a text begins.
fn paths(text: &str) -> Vec<Vec<String>> {
    let end = text.find(|letter: char| !(letter.is_alphanumeric() || letter == '_')).unwrap_or(text.len());
    let (name, rest) = (text[..end].to_owned(), &text[end..]);
    let below: Vec<Vec<String>> = match rest.strip_prefix("::") {
        Some(group) if group.starts_with('{') => branches(&group[1..]).into_iter().flat_map(paths).collect(),
        Some(rest) if rest.starts_with(|letter: char| letter.is_alphabetic() || letter == '_') => paths(rest),
        _ => vec![Vec::new()],
    };
    below.into_iter().map(|path| [vec![name.clone()], path].concat()).collect()
}

/// The parts of a group, up to its closing brace.
fn branches(group: &str) -> Vec<&str> {
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (at, letter) in group.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                parts.push(group[start..at].trim());
                start = at + 1;
                if letter == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    parts.retain(|part| !part.is_empty());
    parts
}
