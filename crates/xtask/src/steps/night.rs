use super::{Step, WEBGL_MODULE, cargo, in_chromium, packages, step, with_command_line};
use crate::need::Need::{Assets, Chromium, Engines, OldChromium, Page, Readers, WasmPack};
use crate::places::target;
use crate::run::Run;
use crate::rust::{CARGO_FUZZ, compiled_by_clippy, native_tests, over_the_workspace};
use crate::setup::Kit;
use crate::{page, python};
use anyhow::Result;
use std::time::{Duration, UNIX_EPOCH};

const DAY: Duration = Duration::from_secs(24 * 3600);
/// Time for each of the five fuzz targets, ten minutes in all.
const FUZZ_SECONDS: u32 = 120;
const MONKEY_LIMIT: Duration = Duration::from_secs(2 * 3600);

/// Slow, downloaded or random checks, and those of the documentation.
pub const NIGHT: [Step; 19] = [
    step("benches", "clippy on the benchmarks", &[Assets], |_| {
        Ok(over_the_workspace("clippy").words("--benches --keep-going -- -D warnings"))
    }),
    step("docs", "rustdoc", &[Assets], |_| {
        Ok(over_the_workspace("doc").words("--no-deps --keep-going").env("RUSTDOCFLAGS", "-D warnings"))
    }),
    step("packages", "contents of the published crates", &[Assets], |_| {
        Ok(cargo("publish --workspace --dry-run --no-verify --allow-dirty --locked"))
    }),
    step("site", "documentation site and its links", &[Assets], |kit| {
        page::build_site(kit)?.checked()?;
        Ok(kit.npm("site").env("ROSTO_SITE", target().join("site")))
    }),
    step("clusters", "Python package in clusters and a notebook", &[Assets], |_| {
        Ok(python::pytest(&python::for_clusters()?).arg("tests/python/night"))
    }),
    step("properties", "all native tests, with fresh seeds", &[Assets], |_| {
        Ok(native_tests(true).env("PROPTEST_RNG_SEED", seed()))
    }),
    step("fuzz:picture", "damaged photos", &[Assets], |_| fuzz("picture")),
    step("fuzz:profile", "damaged colour profiles", &[Assets], |_| fuzz("profile")),
    step("fuzz:glb", "damaged GLBs", &[Assets], |_| fuzz("glb")),
    step("fuzz:project", "damaged projects", &[Assets], |_| fuzz("project")),
    step("fuzz:edits", "damaged edits", &[Assets], |_| fuzz("edits")),
    step("wasm:webgl", "WebGL2 module in headless Chromium", &[Page, WasmPack, Chromium], |kit| {
        let webgl = packages(in_chromium(kit), [WEBGL_MODULE, "rosto-viewport"]);
        Ok(webgl.words("--features rosto-viewport/webgl"))
    }),
    step("readers", "exported files in other programs", &[Page, Chromium, Readers], |kit| {
        with_command_line(kit.npm("readers"))
    }),
    step("rare:1", "first half of the rare end-to-end tests", &[Page, Chromium], |kit| rare(kit, 1)),
    step("rare:2", "second half of the rare end-to-end tests", &[Page, Chromium], |kit| rare(kit, 2)),
    step("oldest", "usual end-to-end tests in the oldest Chromium", &[Page, Chromium, OldChromium], |kit| {
        let oldest = kit.program("ROSTO_OLDEST_BROWSER")?;
        with_command_line(kit.npm("e2e").env("ROSTO_BROWSER", oldest))
    }),
    step("engines", "page in Chromium, Firefox and WebKit with WebGL2", &[Page, Chromium, Engines], |kit| {
        Ok(kit.npm("engines"))
    }),
    step("monkey:desktop", "2,000 random actions with a mouse", &[Page, Chromium], |kit| Ok(monkey(kit, "desktop"))),
    step("monkey:phone", "2,000 random actions with a finger", &[Page, Chromium], |kit| Ok(monkey(kit, "phone"))),
];

/// Half of the rare end-to-end tests, so that a run can be continued in the middle.
fn rare(kit: &Kit, half: u32) -> Result<Run> {
    with_command_line(kit.npm("e2e:rare").args(["--".to_owned(), format!("--shard={half}/2")]))
}

/// Days since 1970: other cases each day, and the same ones when a failure is repeated.
fn seed() -> String {
    let since = UNIX_EPOCH.elapsed().unwrap_or_default();
    (since.as_secs() / DAY.as_secs()).to_string()
}

/// Random actions on the built page by one kind of visitor.
fn monkey(kit: &Kit, visitor: &str) -> Run {
    let monkey = kit.npm("monkey").args(["--", "--visitor", visitor, "--actions", "2000", "--seed", &seed()]);
    monkey.within(MONKEY_LIMIT)
}

/// Coverage-guided fuzzing of one target, without a sanitizer, which would need an unstable compiler.
fn fuzz(target: &str) -> Result<Run> {
    let program = CARGO_FUZZ.obtain()?.join("cargo-fuzz");
    let seeds = cargo("run --quiet --locked --package rosto-fuzz --example seeds tests/fuzz/corpus");
    compiled_by_clippy(seeds).log("seeds").checked()?;
    let run = Run::new(program).words("run --fuzz-dir tests/fuzz --sanitizer none --features libfuzzer").arg(target);
    // Optimising all crates once more would take minutes for each target.
    let run = run.env("CARGO_PROFILE_RELEASE_LTO", "off");
    Ok(run.words(&format!("-- -timeout=10 -max_total_time={FUZZ_SECONDS} -seed={}", seed())))
}
