//! The measuring programs and what each needs.

use crate::places::{WASM, assets, root, target};
use crate::run::Run;
use crate::setup::Kit;
use crate::{page, python};
use anyhow::{Result, bail};
use std::path::PathBuf;

/// A program that measures.
pub struct Source {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it measures.
    pub what: &'static str,
    /// Runs it; returns what it printed.
    pub measure: fn(&Kit) -> Result<String>,
}

const MEDIAPIPE: &str = "tests/reference/mediapipe_requirements.txt";
const PEERS: &str = "tests/bench/peers.py";
const REQUIREMENTS: &str = "tests/bench/requirements.txt";
/// Needs a C library and a compiler: a peer where it installs, left out where it does not.
const OPTIONAL_REQUIREMENTS: &str = "tests/bench/requirements-cholmod.txt";

const ALL: [Source; 11] = [
    Source { name: "engine", what: "editing, beside the paper's dense pseudo-inverse, natively", measure: engine },
    Source { name: "peers", what: "the same in NumPy, SciPy, libigl and CHOLMOD", measure: peers },
    Source { name: "landmarks", what: "photo to landmarks, natively", measure: landmarks },
    Source { name: "many", what: "many photos to landmarks in Python, beside MediaPipe's package", measure: many },
    Source { name: "photo", what: "edits in a photo of 12 megapixels, natively", measure: photo },
    Source {
        name: "texture",
        what: "a face's whole texture, natively, and how far it is from the truth",
        measure: texture,
    },
    Source { name: "chrome-edits", what: "editing in headless Chrome", measure: chrome_edits },
    Source { name: "chrome-page", what: "a slider's tick on the page with all its listeners", measure: chrome_page },
    Source {
        name: "chrome-photo",
        what: "edits in a photo of 12 megapixels in headless Chrome",
        measure: chrome_photo,
    },
    Source {
        name: "chrome-landmarks",
        what: "photo to landmarks and each network in headless Chrome, beside MediaPipe's own and onnxruntime-web",
        measure: chrome_landmarks,
    },
    Source {
        name: "chrome-film",
        what: "following a face through a film in headless Chrome, beside MediaPipe's own",
        measure: chrome_film,
    },
];

/// Those named, or all.
pub fn chosen(wanted: &[&str]) -> Result<Vec<&'static Source>> {
    if let Some(unknown) = wanted.iter().find(|name| !ALL.iter().any(|source| source.name == **name)) {
        let names = ALL.iter().map(|source| source.name).collect::<Vec<_>>().join(", ");
        bail!("`{unknown}` is not a benchmark; there are {names}");
    }
    Ok(ALL.iter().filter(|source| wanted.is_empty() || wanted.contains(&source.name)).collect())
}

fn engine(_: &Kit) -> Result<String> {
    example("rosto-laplacian", "bench", &[])
}

fn landmarks(_: &Kit) -> Result<String> {
    example("rosto-landmarks", "bench", &[assets()])
}

fn many(_: &Kit) -> Result<String> {
    let python = python::environment(&[MEDIAPIPE, python::MATURIN], "MediaPipe's package is compared with ours")?;
    python::install_package(&python, "--release")?;
    let script = Run::new(python).arg(root().join("tests/bench/many.py"));
    script.arg(assets().join("sample.png")).checked()
}

fn photo(_: &Kit) -> Result<String> {
    example("rosto-studio", "photo", &[])
}

fn texture(_: &Kit) -> Result<String> {
    example("rosto-studio", "texture", &[])
}

fn example(package: &str, name: &str, arguments: &[PathBuf]) -> Result<String> {
    let cargo = Run::new("cargo").current_dir(root()).args(["run", "--quiet", "--release", "--locked"]);
    let run = cargo.args(["--package", package, "--example", name, "--"]).args(arguments);
    run.checked()
}

fn peers(_: &Kit) -> Result<String> {
    let python = python_with_peers()?;
    Run::new(python).arg(root().join(PEERS)).checked()
}

fn chrome_edits(kit: &Kit) -> Result<String> {
    example_for_web(kit, &["--package", "rosto-studio-web", "--example", "edits"], "edits.wasm")?;
    in_chrome(kit, "tests/bench/chrome-edits.mjs")
}

/// Builds an example as the page is built.
fn example_for_web(kit: &Kit, example: &[&str], module: &str) -> Result<()> {
    let build = kit.run("cargo").args(["build", "--quiet", "--locked", "--profile", "web", "--target", WASM]);
    build.args(example).checked()?;
    let module = target().join(WASM).join("web/examples").join(module);
    let bind = kit.run("wasm-bindgen").args(["--target", "web", "--no-typescript", "--out-dir"]);
    bind.arg(target().join("bench")).arg(module).checked()?;
    Ok(())
}

fn chrome_page(kit: &Kit) -> Result<String> {
    in_chrome(kit, "tests/bench/chrome-page.mjs")
}

fn chrome_photo(kit: &Kit) -> Result<String> {
    in_chrome(kit, "tests/bench/chrome-photo.mjs")
}

fn chrome_landmarks(kit: &Kit) -> Result<String> {
    let networks = ["--package", "rosto-vision-web", "--features", "bench", "--example", "networks"];
    example_for_web(kit, &networks, "networks.wasm")?;
    in_chrome(kit, "tests/bench/chrome-landmarks.mjs")
}

fn chrome_film(kit: &Kit) -> Result<String> {
    in_chrome(kit, "tests/bench/chrome-film.mjs")
}

/// Runs a script that visits the page as it is built for the web.
fn in_chrome(kit: &Kit, script: &str) -> Result<String> {
    page::build(kit)?;
    kit.run("node").arg(script).checked()
}

/// A Python of its own with the peers.
fn python_with_peers() -> Result<PathBuf> {
    python::environment(&[REQUIREMENTS, OPTIONAL_REQUIREMENTS], "the peers, CHOLMOD too").or_else(|_| {
        println!("  · CHOLMOD is left out: it does not install here, and on Debian it needs libsuitesparse-dev");
        python::environment(&[REQUIREMENTS], "the peers")
    })
}
