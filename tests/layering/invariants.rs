//! What must not be, as ARCHITECTURE.md says it.

use crate::circles;
use crate::facts::Facts;
use crate::graph::Graph;

/// One absence.
pub struct Invariant {
    /// What ARCHITECTURE.md says, word for word.
    pub says: &'static str,
    /// Where it is broken.
    pub breaches: fn(&Facts) -> Vec<String>,
    /// Breaks it.
    pub plant: fn(&mut Facts),
}

/// Which crates of the workspace each crate may know; the table of ARCHITECTURE.md in the order of the way of the data.
const MAY_KNOW: [(&str, &[&str]); 20] = [
    ("rosto-mesh", &[]),
    ("rosto-laplacian", &["mesh"]),
    ("rosto-photo", &[]),
    ("rosto-landmarks", &["photo"]),
    ("rosto-face", &["laplacian", "mesh", "photo"]),
    ("rosto-solid", &["mesh"]),
    ("rosto-warp", &["laplacian", "mesh", "photo"]),
    ("rosto-texture", &["mesh", "photo"]),
    ("rosto-studio", &["face", "laplacian", "mesh", "texture", "warp"]),
    ("rosto-export", &["face", "mesh", "solid"]),
    ("rosto-stage", &["mesh"]),
    ("rosto-session", &["export", "face", "laplacian", "mesh", "stage", "studio", "warp"]),
    ("rosto-viewport", &["mesh", "stage"]),
    ("rosto-studio-web", &PAGE_MAY_KNOW),
    ("rosto-studio-webgl", &PAGE_MAY_KNOW),
    ("rosto-vision-web", &["landmarks", "photo", "texture", "warp"]),
    ("rosto-cli", &["export", "face", "landmarks", "laplacian", "mesh", "photo", "studio", "warp"]),
    ("rosto-python", &["cli", "landmarks", "laplacian", "mesh", "photo"]),
    ("rosto-model-import", &[]),
    ("xtask", &["model-import"]),
];

const PAGE_MAY_KNOW: [&str; 9] =
    ["warp", "session", "studio", "stage", "viewport", "export", "face", "laplacian", "mesh"];

/// The crates that know neither browser, clock, file, network, environment nor random source.
const CORE: [&str; 13] = [
    "rosto-mesh",
    "rosto-laplacian",
    "rosto-photo",
    "rosto-landmarks",
    "rosto-face",
    "rosto-solid",
    "rosto-warp",
    "rosto-texture",
    "rosto-studio",
    "rosto-export",
    "rosto-stage",
    "rosto-session",
    VIEWPORT,
];

/// The one of them that draws.
const VIEWPORT: &str = "rosto-viewport";

/// What the page's JavaScript calls.
const FACADES: [&str; 3] = ["rosto-studio-web", "rosto-studio-webgl", "rosto-vision-web"];

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
        breaches: |facts| {
            facts.declared.members().iter().flat_map(|package| strangers(&facts.declared, package)).collect()
        },
        plant: |facts| facts.depend("rosto-mesh", "rosto-face"),
    },
    Invariant {
        says: "No modules of a crate use each other in a circle, `xtask`'s apart: what a module uses of its ancestors does not \
               count.",
        breaches: |facts| {
            let crates = facts.sources.iter().filter(|(package, _)| *package != "xtask");
            crates
                .flat_map(|(package, sources)| {
                    circles::of(sources).into_iter().map(move |one| format!("{package}: {one}"))
                })
                .collect()
        },
        plant: |facts| facts.write_beside("rosto-photo", "stored.rs", "use crate::decode::decode;"),
    },
    Invariant {
        says: "No core crate but `viewport` reaches a browser, by however many steps, but for what tract takes along; and \
               only the façades (`studio-web`, `studio-webgl`, `vision-web`) name web-sys.",
        breaches: |facts| {
            let without_tract = without_gpu().filter(|package| *package != "rosto-landmarks");
            let reached = without_tract.flat_map(|package| reaches(&facts.wasm, package, &BROWSER));
            reached.chain(named(&facts.declared, &BROWSER, |package| FACADES.contains(&package))).collect()
        },
        plant: |facts| facts.depend("rosto-export", "web-sys"),
    },
    Invariant {
        says: "No crate but `landmarks` names tract, and the page's modules do not reach it.",
        breaches: |facts| {
            let page =
                ["rosto-studio-web", "rosto-studio-webgl"].iter().flat_map(|p| reaches(&facts.wasm, p, &["tract"]));
            page.chain(named_from(&facts.declared, "tract", "rosto-landmarks")).collect()
        },
        plant: |facts| facts.depend("rosto-face", "tract-onnx"),
    },
    Invariant {
        says: "No crate but `viewport` names wgpu; what does not draw (every other core crate, the worker, the command line) \
               does not reach it.",
        breaches: |facts| {
            let others = ["rosto-vision-web", "rosto-cli"];
            let reached = without_gpu().chain(others).flat_map(|package| {
                [reaches(&facts.wasm, package, &GPU), reaches(&facts.host, package, &GPU)].concat()
            });
            reached.chain(named_from(&facts.declared, "wgpu", VIEWPORT)).collect()
        },
        plant: |facts| facts.depend("rosto-mesh", "wgpu"),
    },
    Invariant {
        says: "No WebGL is in the page's module but in `studio-webgl`'s.",
        breaches: |facts| {
            let has = |package: &str| facts.modules[package].iter().any(|name| name == "glow");
            let wrong = [("rosto-studio-web", false), ("rosto-studio-webgl", true)];
            let wrong = wrong.into_iter().filter(|(package, wanted)| has(package) != *wanted);
            wrong.map(|(package, wanted)| format!("{package} with glow: {}", !wanted)).collect()
        },
        plant: |facts| facts.modules.get_mut("rosto-studio-web").unwrap().push("glow".to_owned()),
    },
    Invariant {
        says: "No core crate reads a clock, a file, the network or the environment.",
        breaches: |facts| facts.words(&CORE, &OUTSIDE),
        plant: |facts| facts.write("rosto-studio", "let now = std::time::Instant::now();"),
    },
    Invariant {
        says: "No core crate draws at random: a seed comes in as a value. (On wasm32 alone `landmarks` names getrandom, to tell \
               tract's which source there is.)",
        breaches: |facts| CORE.iter().flat_map(|package| direct(&facts.host, package, &RANDOM)).collect(),
        plant: |facts| facts.depend("rosto-laplacian", "rand"),
    },
    Invariant {
        says: "No core crate has global state.",
        breaches: |facts| facts.words(&CORE, &GLOBAL),
        plant: |facts| facts.write("rosto-session", "static CACHE: OnceLock<u32> = OnceLock::new();"),
    },
    Invariant {
        says: "No core type is `Serialize`, and no core crate names serde: what a file says is written out where its format is \
               documented (`export`, `studio::project`, the preferences of `session`), so that no file changes because a type \
               does.",
        breaches: |facts| {
            let derived = facts.words(&CORE, &["Serialize", "Deserialize"]);
            derived
                .into_iter()
                .chain(CORE.iter().flat_map(|package| direct(&facts.declared, package, &["serde"])))
                .collect()
        },
        plant: |facts| facts.write("rosto-face", "#[derive(Serialize)]"),
    },
    Invariant {
        says: "No identifier of `mesh`, `laplacian`, `stage` and `viewport` contains `photo`, `landmark`, `selfie` or the type name \
               `Face`: they know meshes, pictures and what is seen of them.",
        breaches: |facts| {
            let general = ["rosto-mesh", "rosto-laplacian", "rosto-stage", "rosto-viewport"];
            facts.words(&general, &["photo", "Photo", "landmark", "Landmark", "LANDMARK", "468", "selfie", "Face"])
        },
        plant: |facts| facts.write("rosto-viewport", "const LANDMARKS: u32 = 468;"),
    },
    Invariant {
        says: "No `f32` is in `mesh` and `laplacian`: mathematics is in `f64`, and single precision begins where a picture is \
               drawn or a file written.",
        breaches: |facts| facts.words(&["rosto-mesh", "rosto-laplacian"], &["f32"]),
        plant: |facts| facts.write("rosto-laplacian", "let weight = 1.0_f32;"),
    },
    Invariant {
        says: "No session is needed to find a face: the worker does not reach `studio`, `stage` or `session`.",
        breaches: |facts| reaches(&facts.wasm, "rosto-vision-web", &["rosto-studio", "rosto-stage", "rosto-session"]),
        plant: |facts| facts.depend("rosto-photo", "rosto-stage"),
    },
];

/// The core crates that draw nothing.
fn without_gpu() -> impl Iterator<Item = &'static str> {
    CORE.into_iter().filter(|package| *package != VIEWPORT)
}

/// Packages of ours that one declares and may not know.
fn strangers(graph: &Graph, package: &str) -> Vec<String> {
    let Some((_, allowed)) = MAY_KNOW.iter().find(|(name, _)| *name == package) else {
        return vec![format!("{package} is missing in the table of who may know whom")];
    };
    let is_allowed = |name: &str| allowed.contains(&name.strip_prefix("rosto-").unwrap_or(name));
    let known = graph.direct(package).into_iter();
    known
        .filter(|name| graph.is_member(name) && !is_allowed(name))
        .map(|name| format!("{package} knows {name}"))
        .collect()
}

/// What of this a package reaches, by whatever way.
fn reaches(graph: &Graph, package: &str, prefixes: &[&str]) -> Vec<String> {
    let reached = graph.reachable(package).into_iter();
    let found = reached.filter(|name| prefixes.iter().any(|prefix| name.starts_with(prefix)));
    found.map(|name| format!("{package} reaches {name}")).collect()
}

/// What of this a package declares itself.
fn direct(graph: &Graph, package: &str, names: &[&str]) -> Vec<String> {
    let declared = graph.direct(package).into_iter();
    declared.filter(|name| names.contains(&name.as_str())).map(|name| format!("{package} names {name}")).collect()
}

/// Packages that declare one of these and for which `may` does not hold.
fn named(graph: &Graph, names: &[&str], may: fn(&str) -> bool) -> Vec<String> {
    let others = graph.members().into_iter().filter(|package| !may(package));
    others.flat_map(|package| direct(graph, &package, names)).collect()
}

/// Packages but one that declare something whose name begins so.
fn named_from(graph: &Graph, prefix: &str, but: &str) -> Vec<String> {
    let others = graph.members().into_iter().filter(|package| package != but);
    let declared =
        others.flat_map(|package| graph.direct(&package).into_iter().map(move |name| (package.clone(), name)));
    declared
        .filter(|(_, name)| name.starts_with(prefix))
        .map(|(package, name)| format!("{package} names {name}"))
        .collect()
}
