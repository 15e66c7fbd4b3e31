//! The invariants of ARCHITECTURE.md, in its words and its order.

use crate::circles;
use crate::facts::{Facts, reachable};
use std::collections::{BTreeMap, BTreeSet};

/// Something that must be absent.
pub struct Invariant {
    /// The words of ARCHITECTURE.md.
    pub says: &'static str,
    /// Finds the breaches.
    pub breaches: fn(&Facts) -> Vec<String>,
    /// Plants one.
    pub plant: fn(&mut Facts),
}

/// The one core crate that draws.
const VIEWPORT: &str = "rosto-viewport";
/// The crates that the page's JavaScript calls.
const FACADES: [&str; 3] = ["rosto-studio-web", "rosto-studio-webgl", "rosto-vision-web"];
/// All others are the core, which knows neither browser, clock, file, network, environment nor random source.
const SHELLS: [&str; 5] = ["rosto-cli", "rosto-python", "rosto-model-import", "rosto-fuzz", "xtask"];

const BROWSER: [&str; 5] = ["web-sys", "js-sys", "wasm-bindgen", "wasm-bindgen-futures", "gloo"];
const GPU: [&str; 2] = ["wgpu", "naga"];
const OUTSIDE: [&str; 8] =
    ["Instant", "SystemTime", "std::fs", "std::net", "std::env", "std::process", "std::io::stdin", "std::thread"];
const RANDOM: [&str; 3] = ["rand", "fastrand", "getrandom"];
const GLOBAL: [&str; 6] = ["static mut", "thread_local!", "OnceLock", "LazyLock", "OnceCell", "Atomic"];

/// All of them, in the order of ARCHITECTURE.md.
pub const INVARIANTS: [Invariant; 13] = [
    Invariant {
        says: "No crate knows another one of ours than those its row in the table above names.",
        breaches: strangers,
        plant: |facts| facts.depend("rosto-mesh", "rosto-face"),
    },
    Invariant {
        says: "No modules of a crate use each other in a circle: what a module uses of its ancestors does not count.",
        breaches: |facts| {
            let crates = facts.sources.iter();
            let circles =
                crates.flat_map(|(package, sources)| circles::of(sources).into_iter().map(move |one| (package, one)));
            circles.map(|(package, one)| format!("{package}: {one}")).collect()
        },
        plant: |facts| facts.write("rosto-photo", "stored.rs", "use crate::decode::decode;"),
    },
    Invariant {
        says: "No core crate but `viewport` reaches a browser, by however many steps, but for what tract takes along; and \
               only the façades (`studio-web`, `studio-webgl`, `vision-web`) name web-sys.",
        breaches: |facts| {
            let without_tract = without_gpu(facts).filter(|package| *package != "rosto-landmarks");
            let reached = without_tract.flat_map(|package| reaches(&facts.wasm, package, &BROWSER));
            reached.chain(named(facts, &BROWSER, &FACADES)).collect()
        },
        plant: |facts| facts.depend("rosto-export", "web-sys"),
    },
    Invariant {
        says: "No crate but `landmarks` names tract, and the page's modules do not reach it.",
        breaches: |facts| {
            let page = FACADES[..2].iter().flat_map(|package| reaches(&facts.wasm, package, &["tract"]));
            page.chain(named(facts, &["tract"], &["rosto-landmarks"])).collect()
        },
        plant: |facts| facts.depend("rosto-face", "tract-onnx"),
    },
    Invariant {
        says: "No crate but `viewport` names wgpu; what does not draw (every other core crate, the worker, the command line) \
               does not reach it.",
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
        says: "No WebGL is in the page's module but in `studio-webgl`'s.",
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
        says: "No core crate reads a clock, a file, the network or the environment.",
        breaches: |facts| facts.words(core(facts), &OUTSIDE),
        plant: |facts| facts.write("rosto-studio", "lib.rs", "let now = std::time::Instant::now();"),
    },
    Invariant {
        says: "No core crate draws at random: a seed comes in as a value. (On wasm32 alone `landmarks` names getrandom, to tell \
               tract's which source there is.)",
        breaches: |facts| {
            let drawn = |package| facts.host[package].iter().filter(|name| RANDOM.contains(&name.as_str()));
            core(facts).flat_map(drawn).map(|name| format!("a core crate names {name}")).collect()
        },
        plant: |facts| facts.depend("rosto-laplacian", "rand"),
    },
    Invariant {
        says: "No core crate has global state.",
        breaches: |facts| facts.words(core(facts), &GLOBAL),
        plant: |facts| facts.write("rosto-session", "lib.rs", "static CACHE: OnceLock<u32> = OnceLock::new();"),
    },
    Invariant {
        says: "No core type is `Serialize`, and no core crate names serde: what a file says is written out where its format is \
               documented (`export`, `studio::project`, the preferences of `session`), so that no file changes because a type \
               does.",
        breaches: |facts| {
            let derived = facts.words(core(facts), &["Serialize", "Deserialize"]);
            let naming = core(facts).filter(|package| facts.declared[*package].contains("serde"));
            derived.into_iter().chain(naming.map(|package| format!("{package} names serde"))).collect()
        },
        plant: |facts| facts.write("rosto-face", "lib.rs", "#[derive(Serialize)]"),
    },
    Invariant {
        says: "No identifier of `mesh`, `laplacian`, `stage` and `viewport` contains `photo`, `landmark`, `selfie` or the type name \
               `Face`: they know meshes, pictures and what is seen of them.",
        breaches: |facts| {
            let general = ["rosto-mesh", "rosto-laplacian", "rosto-stage", "rosto-viewport"];
            facts.words(general, &["photo", "Photo", "landmark", "Landmark", "LANDMARK", "468", "selfie", "Face"])
        },
        plant: |facts| facts.write("rosto-viewport", "lib.rs", "const LANDMARKS: u32 = 468;"),
    },
    Invariant {
        says: "No `f32` is in `mesh` and `laplacian`: mathematics is in `f64`, and single precision begins where a picture is \
               drawn or a file written.",
        breaches: |facts| facts.words(["rosto-mesh", "rosto-laplacian"], &["f32"]),
        plant: |facts| facts.write("rosto-laplacian", "lib.rs", "let weight = 1.0_f32;"),
    },
    Invariant {
        says: "No session is needed to find a face: the worker does not reach `studio`, `stage` or `session`.",
        breaches: |facts| reaches(&facts.wasm, "rosto-vision-web", &["rosto-studio", "rosto-stage", "rosto-session"]),
        plant: |facts| facts.depend("rosto-photo", "rosto-stage"),
    },
];

/// The core crates.
fn core(facts: &Facts) -> impl Iterator<Item = &str> {
    let all = facts.declared.keys().map(String::as_str);
    all.filter(|package| !FACADES.contains(package) && !SHELLS.contains(package))
}

/// The core crates that draw nothing.
fn without_gpu(facts: &Facts) -> impl Iterator<Item = &str> {
    core(facts).filter(|package| *package != VIEWPORT)
}

/// The crates that each crate may know, from the table of ARCHITECTURE.md.
fn may_know() -> BTreeMap<String, BTreeSet<String>> {
    let table = include_str!("../../ARCHITECTURE.md").split("\n## ").find(|section| section.starts_with("The crates"));
    let rows = table.unwrap().lines().filter(|line| line.starts_with("| `"));
    let full_name = |name: &str| if name == "xtask" { name.to_owned() } else { format!("rosto-{name}") };
    let of_row = |row: &str| {
        let mut cells = row.split('|').skip(1).map(|cell| cell.split('`').skip(1).step_by(2).map(full_name).collect());
        let name: BTreeSet<String> = cells.next().unwrap();
        (name.into_iter().next().unwrap(), cells.nth(1).unwrap())
    };
    rows.map(of_row).collect()
}

/// Packages of ours that the others know and may not.
fn strangers(facts: &Facts) -> Vec<String> {
    let allowed = may_know();
    let ours = |name: &&String| facts.declared.contains_key(*name);
    let known = facts.declared.iter().flat_map(|(package, on)| on.iter().filter(ours).map(move |name| (package, name)));
    let strangers = known.filter(|(package, name)| !allowed.get(*package).is_some_and(|names| names.contains(*name)));
    let unlisted = facts.declared.keys().filter(|package| !allowed.contains_key(*package));
    let missing = unlisted.map(|package| format!("{package} is missing in the table of crates"));
    strangers.map(|(package, name)| format!("{package} knows {name}")).chain(missing).collect()
}

/// Packages with one of these prefixes that a package reaches.
fn reaches(graph: &BTreeMap<String, BTreeSet<String>>, package: &str, prefixes: &[&str]) -> Vec<String> {
    let reached = reachable(graph, package).into_iter();
    let found = reached.filter(|name| prefixes.iter().any(|prefix| name.starts_with(prefix)));
    found.map(|name| format!("{package} reaches {name}")).collect()
}

/// Packages that declare something with one of these prefixes, except those that may.
fn named(facts: &Facts, prefixes: &[&str], may: &[&str]) -> Vec<String> {
    let others = facts.declared.iter().filter(|(package, _)| !may.contains(&package.as_str()));
    let declared = others.flat_map(|(package, on)| on.iter().map(move |name| (package, name)));
    let found = declared.filter(|(_, name)| prefixes.iter().any(|prefix| name.starts_with(prefix)));
    found.map(|(package, name)| format!("{package} names {name}")).collect()
}
