//! Steps of `cargo xtask test`.
//!
//! Quick checks come first. Later steps use the results of earlier ones: `dist` builds the types for tsc and the page
//! for the browsers.

use crate::places::{WASM, root, target};
use crate::run::{Run, is_program};
use crate::rust::{command_line, over_the_workspace};
use crate::setup::Kit;
use crate::{page, python};
use anyhow::Result;
use fs_err as fs;

/// A step; it passes if its program exits with status 0.
pub struct Step {
    /// Name on the command line.
    pub name: &'static str,
    /// Description.
    pub what: &'static str,
    /// Prepares the program.
    pub program: fn(&Kit) -> Result<Run>,
}

/// All steps, in order.
pub const ALL: [Step; 20] = [
    step("format", "rustfmt", |_| Ok(cargo("fmt --all --check"))),
    step("lint", "clippy on the host", |_| {
        Ok(over_the_workspace("clippy").words("--all-targets --keep-going -- -D warnings"))
    }),
    step("lint-js", "Biome on JavaScript", |kit| Ok(kit.npm("lint"))),
    step("prose", "plain English in docs, comments, names and words", |kit| Ok(kit.npm("prose"))),
    // Without benchmarks, which run on the host.
    step("lint-wasm", "clippy on wasm32", |kit| {
        let clippy = kit.run("cargo").words("clippy --lib --tests --examples --locked --keep-going --target").arg(WASM);
        Ok(packages(clippy, tested_on_wasm()?).words("-- -D warnings"))
    }),
    step("docs", "rustdoc", |_| {
        Ok(over_the_workspace("doc").words("--no-deps --keep-going").env("RUSTDOCFLAGS", "-D warnings"))
    }),
    step("packages", "contents of the published crates", |_| {
        Ok(cargo("publish --workspace --dry-run --no-verify --allow-dirty --locked"))
    }),
    step("native", "native tests", |_| {
        let runner = if is_program("cargo-nextest") { "nextest run" } else { "test" };
        Ok(over_the_workspace(runner).words("--tests --no-fail-fast"))
    }),
    step("examples", "examples in the documentation", |_| Ok(over_the_workspace("test --doc").arg("--no-fail-fast"))),
    step("python", "Python package, with clusters and a notebook", |_| {
        let pytest = Run::new(python::for_tests()?).words("-m pytest --quiet --disable-warnings -p no:cacheprovider");
        Ok(pytest.arg("tests/python").env("ROSTO_CLI", command_line()?))
    }),
    step("site", "documentation site and its links", |kit| {
        page::build_site(kit)?.checked()?;
        Ok(kit.npm("site").env("ROSTO_SITE", target().join("site")))
    }),
    step("wasm:page", "page module in headless Chromium", |kit| {
        Ok(packages(in_chromium(kit), tested_on_wasm()?.into_iter().filter(|name| name != WORKER_MODULE)))
    }),
    step("wasm:webgl", "WebGL2 module in headless Chromium", |kit| {
        let webgl = packages(in_chromium(kit), [WEBGL_MODULE, "rosto-viewport"]);
        Ok(webgl.words("--features rosto-viewport/webgl"))
    }),
    step("wasm:worker", "worker module in headless Chromium", |kit| Ok(packages(in_chromium(kit), [WORKER_MODULE]))),
    step("dist", "build of the page", |kit| Ok(page::trunk(kit).arg("build"))),
    step("size", "download size against its budget", |kit| Ok(kit.npm("size"))),
    step("types", "tsc on JavaScript", |kit| Ok(kit.npm("check"))),
    step("readers", "exported files in other programs", |kit| with_command_line(kit.npm("readers"))),
    step("e2e", "end-to-end tests in headless Chromium", |kit| with_command_line(kit.npm("e2e"))),
    step("engines", "page in Chromium, Firefox and WebKit with WebGL2", |kit| Ok(kit.npm("engines"))),
];

/// The page's module with the feature `webgl`. Built separately, because cargo would enable the feature for the others too.
const WEBGL_MODULE: &str = "rosto-studio-webgl";
const WORKER_MODULE: &str = "rosto-vision-web";

const fn step(name: &'static str, what: &'static str, program: fn(&Kit) -> Result<Run>) -> Step {
    Step { name, what, program }
}

fn with_command_line(run: Run) -> Result<Run> {
    Ok(run.env("ROSTO_CLI", command_line()?))
}

fn cargo(words: &str) -> Run {
    Run::new("cargo").words(words)
}

/// Tests of a module with that module's features and profile, so that both builds share artefacts.
fn in_chromium(kit: &Kit) -> Run {
    let test = kit.run("wasm-pack").words("test --headless --chrome");
    let driver = std::env::var_os("CHROMEDRIVER");
    let test = driver.iter().fold(test, |test, driver| test.arg("--chromedriver").arg(driver));
    let test = test.arg(root().join("crates/viewport")).words("--locked --profile web");
    test.env("WASM_BINDGEN_TEST_TIMEOUT", "600")
}

fn packages(run: Run, names: impl IntoIterator<Item = impl AsRef<str>>) -> Run {
    names.into_iter().fold(run, |run, name| run.args(["--package", name.as_ref()]))
}

/// Packages with browser tests, sorted.
fn tested_on_wasm() -> Result<Vec<String>> {
    let mut found = Vec::new();
    for folder in fs::read_dir(root().join("crates"))? {
        let folder = folder?;
        let manifest = fs::read_to_string(folder.path().join("Cargo.toml")).unwrap_or_default();
        if manifest.contains("wasm-bindgen-test") {
            found.push(format!("rosto-{}", folder.file_name().to_string_lossy()));
        }
    }
    found.sort();
    Ok(found)
}
