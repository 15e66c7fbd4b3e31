use super::{Step, WORKER_MODULE, cargo, early, in_chromium, packages, step, tested_on_wasm, with_command_line};
use crate::need::Need::{Assets, Chromium, Page, Python, WasmPack};
use crate::page;
use crate::places::WASM;
use crate::python;
use crate::rust::{native_tests, over_the_workspace};

/// Crates with code for wasm32 alone: their libraries differ there.
const WASM_CODE: [&str; 3] = ["rosto-studio-web", "rosto-studio-webgl", "rosto-viewport"];

/// Checks of everything that a change can break in the product, in order.
pub const GATE: [Step; 16] = [
    early("format", "rustfmt", &[], |_| Ok(cargo("fmt --all --check"))),
    early("lint-js", "Biome on JavaScript", &[], |kit| Ok(kit.npm("lint"))),
    early("prose", "plain English in docs, comments, names and words", &[], |kit| Ok(kit.npm("prose"))),
    early("units", "functions of the page without a browser", &[], |kit| Ok(kit.npm("units"))),
    // Without benchmarks, whose libraries nothing else here compiles.
    early("lint", "clippy on the host, and the build of the native tests", &[Assets], |_| {
        Ok(over_the_workspace("build --lib --bins --tests --examples --keep-going"))
    }),
    early("native", "native tests, without slow ones", &[Assets], |_| Ok(native_tests(false))),
    early("examples", "examples in the documentation", &[Assets], |_| {
        Ok(over_the_workspace("test --doc").arg("--no-fail-fast"))
    }),
    step("python", "Python package", &[Assets, Python], |_| {
        let pytest = python::pytest(&python::for_tests()?).words("--numprocesses auto tests/python");
        with_command_line(pytest.arg("--ignore=tests/python/night"))
    }),
    // Only crates with code for wasm32 alone; the worker's façade is checked on the host.
    step("lint-wasm", "clippy on wasm32", &[Page], |kit| {
        let clippy = kit.run("cargo").words("clippy --lib --tests --locked --keep-going --target").arg(WASM);
        Ok(packages(clippy, WASM_CODE).words("-- -D warnings"))
    }),
    // Trunk builds one module after the other, which leaves a core idle.
    step("modules", "modules of page and worker", &[Page], |kit| {
        let build = kit.run("cargo").words("build --lib --locked --profile web --target").arg(WASM);
        Ok(packages(build, ["rosto-studio-web", WORKER_MODULE]))
    }),
    step("dist", "build of the page", &[Page], |kit| Ok(page::trunk(kit).arg("build"))),
    step("size", "download size against its budget", &[Page], |kit| Ok(kit.npm("size"))),
    step("types", "tsc on JavaScript", &[Page], |kit| Ok(kit.npm("check"))),
    step("wasm:page", "page module in headless Chromium", &[Page, WasmPack, Chromium], |kit| {
        Ok(packages(in_chromium(kit), tested_on_wasm()?.into_iter().filter(|name| name != WORKER_MODULE)))
    }),
    step("wasm:worker", "worker module in headless Chromium", &[Page, WasmPack, Chromium], |kit| {
        Ok(packages(in_chromium(kit), [WORKER_MODULE]))
    }),
    step("e2e", "usual end-to-end tests in headless Chromium", &[Page, Chromium], |kit| {
        with_command_line(kit.npm("e2e"))
    }),
];
