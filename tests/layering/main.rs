//! The invariants of ARCHITECTURE.md, each an absence that is looked for.
//!
//! Who may know whom is a table here; `cargo metadata` says who does. What a core crate must not touch is searched for
//! in its sources, the tests inside them left out.

#![cfg(test)]

mod graph;
mod sources;

use graph::Graph;

/// The crates that know neither browser, clock, file, network, environment nor random source.
const CORE: [&str; 10] = [
    "rosto-mesh",
    "rosto-laplacian",
    "rosto-photo",
    "rosto-landmarks",
    "rosto-face",
    "rosto-studio",
    "rosto-export",
    "rosto-session",
    "rosto-stage",
    "rosto-viewport",
];

/// Which crates of the workspace each crate may know.
const MAY_KNOW: [(&str, &[&str]); 16] = [
    ("rosto-mesh", &[]),
    ("rosto-laplacian", &["rosto-mesh"]),
    ("rosto-photo", &[]),
    ("rosto-landmarks", &["rosto-photo"]),
    ("rosto-face", &["rosto-mesh", "rosto-photo"]),
    ("rosto-studio", &["rosto-face", "rosto-laplacian", "rosto-mesh"]),
    ("rosto-export", &["rosto-face", "rosto-mesh"]),
    ("rosto-session", &["rosto-export", "rosto-face", "rosto-laplacian", "rosto-mesh", "rosto-stage", "rosto-studio"]),
    ("rosto-stage", &["rosto-mesh"]),
    ("rosto-viewport", &["rosto-mesh", "rosto-stage"]),
    (
        "rosto-studio-web",
        &[
            "rosto-session",
            "rosto-studio",
            "rosto-stage",
            "rosto-viewport",
            "rosto-export",
            "rosto-face",
            "rosto-laplacian",
            "rosto-mesh",
        ],
    ),
    ("rosto-studio-webgl", &["rosto-studio-web"]),
    ("rosto-vision-web", &["rosto-landmarks", "rosto-photo"]),
    (
        "rosto-cli",
        &[
            "rosto-export",
            "rosto-face",
            "rosto-landmarks",
            "rosto-laplacian",
            "rosto-mesh",
            "rosto-photo",
            "rosto-studio",
        ],
    ),
    ("rosto-model-import", &[]),
    ("xtask", &["rosto-model-import"]),
];

#[test]
fn every_crate_knows_only_whom_it_may() {
    let graph = Graph::of_workspace();
    for package in graph.members() {
        let allowed = MAY_KNOW.iter().find(|(name, _)| *name == package).map(|(_, allowed)| *allowed);
        let allowed = allowed.unwrap_or_else(|| panic!("{package} is missing in the table of who may know whom"));
        let known = graph.direct(&package);
        let strangers: Vec<_> =
            known.iter().filter(|name| graph.is_member(name) && !allowed.contains(&name.as_str())).collect();
        assert!(strangers.is_empty(), "{package} must not depend on {strangers:?}");
    }
}

#[test]
fn only_the_web_shells_depend_on_the_browser() {
    let browser = ["web-sys", "js-sys", "wasm-bindgen", "wasm-bindgen-futures", "gloo"];
    only(|package| package.ends_with("-web"), |name| browser.contains(&name));
}

#[test]
fn only_landmarks_depends_on_tract() {
    only(|package| package == "rosto-landmarks", |name| name.starts_with("tract"));
}

#[test]
fn only_the_viewport_depends_on_wgpu() {
    only(|package| package == "rosto-viewport", |name| name.starts_with("wgpu"));
}

#[test]
fn the_page_carries_no_networks_the_worker_no_canvas_and_the_stage_no_gpu() {
    let graph = Graph::of_wasm();
    let absent = [
        ("rosto-studio-web", "tract"),
        ("rosto-vision-web", "wgpu"),
        ("rosto-vision-web", "rosto-studio"),
        ("rosto-stage", "wgpu"),
    ];
    for (package, prefix) in absent {
        let reached: Vec<_> = graph.reachable(package).into_iter().filter(|name| name.starts_with(prefix)).collect();
        assert!(reached.is_empty(), "{package} reaches {reached:?}");
    }
}

#[test]
fn webgl_is_in_the_module_of_its_own_alone() {
    let reaches_webgl = |package| graph::built_for_wasm(package).contains("glow");
    assert!(!reaches_webgl("rosto-studio-web"));
    assert!(reaches_webgl("rosto-studio-webgl"));
}

#[test]
fn the_command_line_draws_nothing() {
    let reached = Graph::of_host().reachable("rosto-cli");
    assert!(!reached.iter().any(|name| name.starts_with("wgpu") || name == "rosto-viewport"));
}

#[test]
fn a_session_needs_neither_a_browser_nor_a_gpu() {
    let reached = Graph::of_host().reachable("rosto-session");
    assert!(reached.contains("rosto-stage"), "{reached:?}");
    let absent = ["wgpu", "web-sys", "js-sys", "wasm-bindgen"];
    let found: Vec<_> = reached.iter().filter(|name| absent.iter().any(|prefix| name.starts_with(prefix))).collect();
    assert!(found.is_empty(), "rosto-session reaches {found:?}");
}

#[test]
fn core_types_are_not_serialisable() {
    let graph = Graph::of_workspace();
    for package in CORE {
        assert!(!graph.direct(package).iter().any(|name| name == "serde"), "{package} must not depend on serde");
    }
    sources::assert_absent(&CORE, &["Serialize", "Deserialize"]);
}

#[test]
fn the_core_reads_no_clock_file_network_environment_or_random_source() {
    let forbidden = ["Instant", "SystemTime", "std::fs", "std::net", "std::env", "std::process", "std::io::stdin"];
    sources::assert_absent(&CORE, &forbidden);
    let random = ["rand", "fastrand", "getrandom"];
    let graph = Graph::of_host();
    for package in CORE {
        assert!(!graph.direct(package).iter().any(|name| random.contains(&name.as_str())), "{package}");
    }
}

#[test]
fn the_core_has_no_global_state() {
    sources::assert_absent(&CORE, &["static mut", "thread_local!", "OnceLock", "LazyLock", "OnceCell", "Atomic"]);
}

#[test]
fn single_precision_begins_where_the_picture_is_drawn_and_the_file_is_written() {
    sources::assert_absent(&["rosto-mesh", "rosto-laplacian"], &["f32"]);
}

/// Only packages for which `allowed` holds may depend directly on packages for which `wanted` holds.
fn only(allowed: impl Fn(&str) -> bool, wanted: impl Fn(&str) -> bool) {
    let graph = Graph::of_workspace();
    for package in graph.members().into_iter().filter(|package| !allowed(package)) {
        let found: Vec<_> = graph.direct(&package).into_iter().filter(|name| wanted(name)).collect();
        assert!(found.is_empty(), "{package} must not depend on {found:?}");
    }
}
