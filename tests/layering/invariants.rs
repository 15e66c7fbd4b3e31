//! The invariants of ARCHITECTURE.md, word for word, with a check and a planted breach for each.

use crate::cycles;
use crate::facts::{Facts, reachable};
use std::collections::{BTreeMap, BTreeSet};

/// An architecture invariant.
pub struct Invariant {
    /// Its text in ARCHITECTURE.md.
    pub text: &'static str,
    /// Finds the breaches.
    pub breaches: fn(&Facts) -> Vec<String>,
    /// Plants a breach.
    pub plant: fn(&mut Facts),
}

/// The core crate that draws.
const VIEWPORT: &str = "rosto-viewport";
/// The core crate whose messages the page sends and receives.
const SESSION: &str = "rosto-session";
/// The crates that the page's JavaScript calls.
const FACADES: [&str; 3] = ["rosto-studio-web", "rosto-studio-webgl", "rosto-vision-web"];
/// The other shells. Crates that are neither façade nor shell are the core.
const SHELLS: [&str; 5] = ["rosto-cli", "rosto-python", "rosto-model-import", "rosto-fuzz", "xtask"];

const BROWSER: [&str; 5] = ["web-sys", "js-sys", "wasm-bindgen", "wasm-bindgen-futures", "gloo"];
const GPU: [&str; 2] = ["wgpu", "naga"];
const OUTSIDE: [&str; 8] =
    ["Instant", "SystemTime", "std::fs", "std::net", "std::env", "std::process", "std::io::stdin", "std::thread"];
const RANDOM: [&str; 3] = ["rand", "fastrand", "getrandom"];
const GLOBAL: [&str; 6] = ["static mut", "thread_local!", "OnceLock", "LazyLock", "OnceCell", "Atomic"];

/// The invariants.
pub const INVARIANTS: [Invariant; 13] = [
    Invariant {
        text: "A crate depends only on the workspace crates that its row in this table lists.",
        breaches: undeclared,
        plant: |facts| facts.depend("rosto-mesh", "rosto-face"),
    },
    Invariant {
        text: "The modules of a crate form no dependency cycle. A module may use its ancestors.",
        breaches: |facts| {
            let crates = facts.sources.iter();
            let cycles =
                crates.flat_map(|(package, sources)| cycles::of(sources).into_iter().map(move |one| (package, one)));
            cycles.map(|(package, one)| format!("{package}: {one}")).collect()
        },
        plant: |facts| facts.write("rosto-photo", "stored.rs", "use crate::decode::decode;"),
    },
    Invariant {
        text: "Apart from `viewport`, from `landmarks` through tract, and from `session`, no core crate reaches a browser \
               binding. Only the façades (`studio-web`, `studio-webgl`, `vision-web`) depend on one directly, and `session` \
               on wasm-bindgen, with which tsify writes the TypeScript types of the messages.",
        breaches: |facts| {
            let without = without_gpu(facts).filter(|package| !["rosto-landmarks", SESSION].contains(package));
            let reached = without.flat_map(|package| reaches(&facts.wasm, package, &BROWSER));
            let direct = named(facts, &BROWSER, &FACADES).into_iter();
            reached.chain(direct.filter(|breach| *breach != format!("{SESSION} depends on wasm-bindgen"))).collect()
        },
        plant: |facts| facts.depend("rosto-export", "web-sys"),
    },
    Invariant {
        text: "Only `landmarks` depends on tract directly, and the page's modules do not reach it.",
        breaches: |facts| {
            let page = FACADES[..2].iter().chain(&["rosto-session"]);
            let page = page.flat_map(|package| reaches(&facts.wasm, package, &["tract"]));
            page.chain(named(facts, &["tract"], &["rosto-landmarks"])).collect()
        },
        plant: |facts| facts.depend("rosto-face", "tract-onnx"),
    },
    Invariant {
        text: "Only `viewport` depends on wgpu directly. The other core crates, the worker and the command line do not reach \
               it.",
        breaches: |facts| {
            let others = ["rosto-vision-web", "rosto-cli"];
            let reached = without_gpu(facts).chain(others).flat_map(|package| {
                [reaches(&facts.wasm, package, &GPU), reaches(&facts.host, package, &GPU)].concat()
            });
            reached.chain(named(facts, &["wgpu"], &[VIEWPORT])).collect()
        },
        plant: |facts| facts.depend("rosto-mesh", "wgpu"),
    },
    Invariant {
        text: "Only the page module that is built from `studio-webgl` contains WebGL.",
        breaches: |facts| {
            let wanted = [("rosto-studio-web", false), ("rosto-studio-webgl", true)].into_iter();
            let wrong = wanted.filter(|(package, wanted)| facts.modules[package].contains("glow") != *wanted);
            wrong.map(|(package, wanted)| format!("{package} with glow: {}", !wanted)).collect()
        },
        plant: |facts| {
            facts.modules.get_mut("rosto-studio-web").unwrap().insert("glow".to_owned());
        },
    },
    Invariant {
        text: "The core crates do not read a clock, a file, the network or the environment.",
        breaches: |facts| facts.words(core(facts), &OUTSIDE),
        plant: |facts| facts.write("rosto-studio", "lib.rs", "let now = std::time::Instant::now();"),
    },
    Invariant {
        text: "The core crates use no random source; callers pass a seed. On wasm32, `landmarks` names getrandom to select a \
               source for tract.",
        breaches: |facts| {
            let drawn = |package| facts.host[package].iter().filter(|name| RANDOM.contains(&name.as_str()));
            core(facts).flat_map(drawn).map(|name| format!("a core crate depends on {name}")).collect()
        },
        plant: |facts| facts.depend("rosto-laplacian", "rand"),
    },
    Invariant {
        text: "The core crates have no global state.",
        breaches: |facts| facts.words(core(facts), &GLOBAL),
        plant: |facts| facts.write("rosto-session", "lib.rs", "static CACHE: OnceLock<u32> = OnceLock::new();"),
    },
    Invariant {
        text: "Only `session` depends on serde, for its messages to the page; the other core crates do not, and their types \
               do not implement `Serialize`. The code that writes a file format spells out its fields, so that renaming a \
               field of a type does not change a file.",
        breaches: |facts| {
            let others = || core(facts).filter(|package| *package != SESSION);
            let derived = facts.words(others(), &["Serialize", "Deserialize"]);
            let naming = others().filter(|package| facts.declared[*package].contains("serde"));
            derived.into_iter().chain(naming.map(|package| format!("{package} depends on serde"))).collect()
        },
        plant: |facts| facts.write("rosto-face", "lib.rs", "#[derive(Serialize)]"),
    },
    Invariant {
        text: "The identifiers of `mesh`, `laplacian`, `stage` and `viewport` do not contain `photo`, `landmark`, `selfie` \
               or the type name `Face`, except in the viewport's `photo_layer`.",
        breaches: |facts| {
            let general = ["rosto-mesh", "rosto-laplacian", "rosto-stage", "rosto-viewport"];
            let words = ["photo", "Photo", "landmark", "Landmark", "LANDMARK", "468", "selfie", "Face"];
            let is_breach = |line: &String| {
                let code = line.replace("photo_layer", "").replace("PhotoLayer", "");
                code.split_once(": ").is_some_and(|(_, code)| words.iter().any(|word| code.contains(word)))
            };
            facts.words(general, &words).into_iter().filter(is_breach).collect()
        },
        plant: |facts| facts.write("rosto-viewport", "lib.rs", "const LANDMARKS: u32 = 468;"),
    },
    Invariant {
        text: "`mesh` and `laplacian` contain no `f32`. Mathematics uses `f64`; single precision begins where a picture is \
               drawn or a file is written.",
        breaches: |facts| facts.words(["rosto-mesh", "rosto-laplacian"], &["f32"]),
        plant: |facts| facts.write("rosto-laplacian", "lib.rs", "let weight = 1.0_f32;"),
    },
    Invariant {
        text: "Finding a face needs no session: the worker does not reach `stage`, `session` or `viewport`.",
        breaches: |facts| reaches(&facts.wasm, "rosto-vision-web", &["rosto-stage", "rosto-session", VIEWPORT]),
        plant: |facts| facts.depend("rosto-photo", "rosto-stage"),
    },
];

/// The core crates.
fn core(facts: &Facts) -> impl Iterator<Item = &str> {
    let all = facts.declared.keys().map(String::as_str);
    all.filter(|package| !FACADES.contains(package) && !SHELLS.contains(package))
}

/// The core crates that do not draw.
fn without_gpu(facts: &Facts) -> impl Iterator<Item = &str> {
    core(facts).filter(|package| *package != VIEWPORT)
}

/// The workspace crates that each crate may depend on, from the table in ARCHITECTURE.md.
fn allowed() -> BTreeMap<String, BTreeSet<String>> {
    let table =
        include_str!("../../ARCHITECTURE.md").split("\n## ").find(|section| section.starts_with("Dependencies"));
    let rows = table.unwrap().lines().filter(|line| line.starts_with("| `"));
    let full_name =
        |name: &str| if ["rosto", "xtask"].contains(&name) { name.to_owned() } else { format!("rosto-{name}") };
    let of_row = |row: &str| {
        let mut cells = row.split('|').skip(1).map(|cell| cell.split('`').skip(1).step_by(2).map(full_name).collect());
        let name: BTreeSet<String> = cells.next().unwrap();
        (name.into_iter().next().unwrap(), cells.next().unwrap())
    };
    rows.map(of_row).collect()
}

/// Dependencies between workspace crates that the table does not allow, and crates that it lacks.
fn undeclared(facts: &Facts) -> Vec<String> {
    let allowed = allowed();
    let ours = |name: &&String| facts.declared.contains_key(*name);
    let all = facts.declared.iter().flat_map(|(package, on)| on.iter().filter(ours).map(move |name| (package, name)));
    let undeclared = all.filter(|(package, name)| !allowed.get(*package).is_some_and(|names| names.contains(*name)));
    let unlisted = facts.declared.keys().filter(|package| !allowed.contains_key(*package));
    let missing = unlisted.map(|package| format!("{package} is missing from the table in ARCHITECTURE.md"));
    undeclared.map(|(package, name)| format!("{package} depends on {name}")).chain(missing).collect()
}

/// Packages with one of these prefixes that a package depends on, directly or transitively.
fn reaches(graph: &BTreeMap<String, BTreeSet<String>>, package: &str, prefixes: &[&str]) -> Vec<String> {
    let reached = reachable(graph, package).into_iter();
    let found = reached.filter(|name| prefixes.iter().any(|prefix| name.starts_with(prefix)));
    found.map(|name| format!("{package} reaches {name}")).collect()
}

/// Packages outside `allowed` that declare a dependency with one of these prefixes.
fn named(facts: &Facts, prefixes: &[&str], allowed: &[&str]) -> Vec<String> {
    let others = facts.declared.iter().filter(|(package, _)| !allowed.contains(&package.as_str()));
    let declared = others.flat_map(|(package, on)| on.iter().map(move |name| (package, name)));
    let found = declared.filter(|(_, name)| prefixes.iter().any(|prefix| name.starts_with(prefix)));
    found.map(|(package, name)| format!("{package} depends on {name}")).collect()
}
