//! What is checked, in which order, by which program.
//!
//! The order keeps quick checks first and lets later steps use what earlier ones built: the page built for the web
//! carries the types that tsc reads and is what the journeys visit.

use super::counts::{self, Counts};
use crate::browser::Browser;
use crate::failure::{Doing, Result};
use crate::process::{Run, find_program};
use crate::setup::Kit;
use crate::toolchain::WASM;
use crate::{crates, dist, site, size, wheel, workspace};
use std::path::PathBuf;
use std::time::Duration;

/// One step of the tests.
pub struct Step {
    /// Its name on the command line.
    pub name: String,
    /// What it checks, for the reader of the log.
    pub what: &'static str,
    /// Does it.
    pub work: Work,
}

/// What a step does; `Err` if a program it needs could not be started.
type Work = Box<dyn FnOnce(&Kit) -> Result<Report>>;

/// What came of a step.
pub struct Report {
    /// Its tests; a check without tests of its own counts as one.
    pub counts: Counts,
    /// All it printed.
    pub output: String,
}

const STEP_LIMIT: Duration = Duration::from_secs(3600);
/// No step that goes on is silent for so long, the slowest crate's compilation included.
const SILENCE_LIMIT: Duration = Duration::from_secs(1200);
/// Set for rustdoc and clippy alike: a warning is an error.
const DENY: [&str; 2] = ["-D", "warnings"];
const WASM_TEST_LIMIT_S: &str = "600";
/// The façades, by a pattern of cargo's. On this machine's target they would be built for nobody.
const FACADES: &str = "rosto-*-web*";
/// The page's module with the feature `webgl`. Whatever cargo builds together with it gets the feature, too.
const WEBGL_MODULE: &str = "rosto-studio-webgl";
/// The worker's module.
const WORKER_MODULE: &str = "rosto-vision-web";
/// What has the feature `webgl` of its own.
const VIEW: &str = "rosto-viewport";

impl Step {
    /// Whether the command line means this step: by its name, or by the part before the colon.
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.name.split(':').next() == Some(name)
    }

    fn new(name: impl Into<String>, what: &'static str, work: impl FnOnce(&Kit) -> Result<Report> + 'static) -> Self {
        Self { name: name.into(), what, work: Box::new(work) }
    }
}

impl Report {
    /// A step that could not be carried out.
    pub fn failed(output: String) -> Self {
        Self { counts: Counts::of_one(false), output }
    }

    fn passed() -> Self {
        Self { counts: Counts::of_one(true), output: String::new() }
    }
}

/// All steps in their order.
pub fn all() -> Result<Vec<Step>> {
    let tested_on_wasm = tested_on_wasm()?;
    let mut steps = vec![
        Step::new("format", "rustfmt", |_| check("format", cargo().args(["fmt", "--all", "--check"]))),
        native_lint(),
        scripts_lint(),
        wasm_lint(tested_on_wasm.clone()),
        rustdoc(),
        packages(),
    ];
    steps.extend(native_tests());
    steps.push(python());
    steps.push(documentation());
    steps.extend(wasm_tests(tested_on_wasm));
    steps.extend(page());
    Ok(steps)
}

fn native_lint() -> Step {
    Step::new("lint", "clippy on this machine's target", |_| {
        let clippy = over_the_workspace(&["clippy"]).args(["--all-targets", "--keep-going"]);
        check("lint", clippy.arg("--").args(DENY))
    })
}

fn scripts_lint() -> Step {
    Step::new("lint-js", "Biome over the page's JavaScript and the tests'", |kit| {
        check("lint-js", quiet(kit.run("npm")?).args(["run", "--silent", "lint"]))
    })
}

/// The module for WebGL2 is left out: it is made of the same sources. Benchmarks run natively.
fn wasm_lint(crates: Vec<String>) -> Step {
    Step::new("lint-wasm", "clippy on wasm32, for what runs in the browser", move |kit| {
        let clippy = quiet(kit.run("cargo")?).args(["clippy", "--lib", "--tests", "--examples", "--locked"]);
        let clippy = clippy.args(["--keep-going", "--target", WASM]);
        check("lint-wasm", clippy.args(only(&crates)).arg("--").args(DENY))
    })
}

fn rustdoc() -> Step {
    Step::new("docs", "rustdoc without warnings", |_| {
        let doc = over_the_workspace(&["doc"]).args(["--no-deps", "--keep-going"]);
        check("docs", doc.env("RUSTDOCFLAGS", DENY.join(" ")))
    })
}

fn packages() -> Step {
    Step::new("packages", "what the published crates would hold", |_| {
        let faults = crates::check_packages()?;
        Ok(Report { counts: Counts::of_one(faults.is_empty()), output: faults.join("\n") })
    })
}

fn native_tests() -> Vec<Step> {
    let native = |program: &'static [&'static str]| {
        Step::new("native", "theorems, golden numbers, shaders, layering", move |_| {
            tests("native", over_the_workspace(program).arg("--no-fail-fast"))
        })
    };
    if find_program("cargo-nextest").is_none() {
        return vec![native(&["test"])];
    }
    let examples = Step::new("examples", "the examples in the documentation", |_| {
        examples("examples", over_the_workspace(&["test", "--doc"]).arg("--no-fail-fast"))
    });
    vec![native(&["nextest", "run"]), examples]
}

/// After the native tests, which have built all that the package is made of.
fn python() -> Step {
    Step::new("python", "the Python package, on clusters and in a notebook, too", |_| {
        let (python, program) = (wheel::for_tests()?, command_line()?);
        let pytest = Run::new(python).args([
            "-m",
            "pytest",
            "-qq",
            "--disable-warnings",
            "-p",
            "no:cacheprovider",
            "tests/python",
        ]);
        tests("python", pytest.current_dir(workspace::root()).env("ROSTO_CLI", program))
    })
}

fn documentation() -> Step {
    Step::new("site", "the documentation as a site, and every link in it", |kit| {
        site::build(kit, command_line()?)?;
        tests("site", quiet(site::tests(kit)?))
    })
}

/// A command of cargo's for all that runs on this machine's target.
fn over_the_workspace(command: &[&str]) -> Run {
    cargo().args(command.iter().copied()).args(["--workspace", "--exclude", FACADES, "--locked"])
}

/// The tests of each of the page's modules together with the module's own features, and in its profile: so that they and
/// the page are built of the same.
fn wasm_tests(tested: Vec<String>) -> Vec<Step> {
    let (worker, page) = tested.into_iter().partition(|name| name == WORKER_MODULE);
    vec![
        wasm_tests_of("page", page, None),
        wasm_tests_of("webgl", vec![WEBGL_MODULE.to_owned(), VIEW.to_owned()], Some("rosto-viewport/webgl")),
        wasm_tests_of("worker", worker, None),
    ]
}

fn wasm_tests_of(module: &'static str, packages: Vec<String>, feature: Option<&'static str>) -> Step {
    Step::new(format!("wasm:{module}"), "in headless Chrome", move |kit| {
        let test = quiet(kit.run("wasm-pack")?).args(["test", "--headless", "--chrome"]);
        let driver = kit.browser().and_then(|browser: &Browser| browser.driver.clone());
        let test = driver.iter().fold(test, |test, driver| test.arg("--chromedriver").arg(driver));
        let test = test.arg(workspace::root().join("crates/viewport"));
        let test = test.args(["--locked", "--profile", "web"]).args(only(&packages));
        let test = feature.iter().fold(test, |test, feature| test.args(["--features", feature]));
        tests(&format!("wasm-{module}"), test.env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TEST_LIMIT_S))
    })
}

fn page() -> Vec<Step> {
    vec![
        Step::new("dist", "the page built for the web", |kit| dist::build(kit).map(|_| Report::passed())),
        Step::new("size", "what a visitor downloads, against its budget", |_| {
            let rows = size::weigh(&workspace::dist())?;
            println!("{}", size::table(&rows));
            let budgeted = rows.iter().filter(|row| row.limit.is_some());
            let counts = budgeted.map(|row| Counts::of_one(row.fits())).fold(Counts::default(), Counts::plus);
            Ok(Report { counts, output: "a part is over its budget".to_owned() })
        }),
        Step::new("types", "tsc over the page's scripts", |kit| {
            check("types", quiet(kit.run("npm")?).args(["run", "--silent", "check"]))
        }),
        Step::new("readers", "every file opened by programs that are not ours", opened_elsewhere),
        Step::new("journeys", "a visitor's ways through the page, in headless Chrome", journeys),
        Step::new("engines", "the core way through the page in Chromium, Firefox and WebKit, by WebGL2", engines),
    ]
}

/// The page's results are compared with those of the command line, as the native tests build it.
fn journeys(kit: &Kit) -> Result<Report> {
    let program = command_line()?;
    tests("journeys", quiet(kit.run("npm")?).args(["run", "--silent", "journeys"]).env("ROSTO_CLI", program))
}

/// Each reader of each file is a test; what could not be had is left out, with the reason, where everything need not be there.
fn opened_elsewhere(kit: &Kit) -> Result<Report> {
    let report = tests("readers", kit.readers().over_all_files(quiet(kit.run("npm")?), command_line()?))?;
    let missing: String = kit.readers().missing().iter().map(|failure| format!("{failure}\n")).collect();
    let left_out = report.output.lines().filter(|line| line.starts_with('﹣'));
    left_out.for_each(|line| println!("  {line}"));
    Ok(Report { output: format!("{missing}{}", report.output), ..report })
}

/// The command line's program as the native tests build it.
pub fn command_line() -> Result<PathBuf> {
    over_the_workspace(&["test", "--quiet", "--no-run"]).within(STEP_LIMIT).run()?.checked()?;
    Ok(workspace::target().join("debug").join("rosto"))
}

/// Each engine is a test; one that could not be had fails, with the reason.
fn engines(kit: &Kit) -> Result<Report> {
    let report = tests("engines", quiet(kit.run("npm")?).args(["run", "--silent", "engines"]))?;
    let missing: String = kit.missing_engines().iter().map(|failure| format!("{failure}\n")).collect();
    let table: String =
        report.output.lines().filter(|line| line.starts_with('|')).map(|row| format!("  {row}\n")).collect();
    print!("{table}");
    Ok(Report { output: format!("{missing}{}", report.output), ..report })
}

/// A program whose success is one test.
fn check(name: &str, run: Run) -> Result<Report> {
    let ended = run.within(STEP_LIMIT).log_to(log(name)?).run()?;
    let counts = Counts::of_one(ended.success);
    Ok(Report { counts, output: format!("{}{}", ended.output, ended.given_up.unwrap_or_default()) })
}

/// A test runner.
fn tests(name: &str, run: Run) -> Result<Report> {
    let run = run.within(STEP_LIMIT).unless_stalled(SILENCE_LIMIT, workspace::logs()?);
    let ended = run.log_to(log(name)?).run()?;
    let counts = Counts::of_runner(ended.success, &ended.output);
    Ok(Report { counts, output: format!("{}{}", ended.output, ended.given_up.unwrap_or_default()) })
}

/// A test runner that may have nothing to run.
fn examples(name: &str, run: Run) -> Result<Report> {
    let ended = run.within(STEP_LIMIT).log_to(log(name)?).run()?;
    let counts = if ended.success { counts::read(&ended.output) } else { Counts::of_runner(false, &ended.output) };
    Ok(Report { counts, output: ended.output })
}

fn log(name: &str) -> Result<PathBuf> {
    Ok(workspace::logs()?.join(format!("{name}.log")))
}

/// The present toolchain's cargo.
fn cargo() -> Run {
    quiet(Run::new("cargo").current_dir(workspace::root()))
}

fn quiet(run: Run) -> Run {
    run.env("CARGO_TERM_COLOR", "never").env("NO_COLOR", "1")
}

fn only(packages: &[String]) -> Vec<String> {
    packages.iter().flat_map(|package| ["--package".to_owned(), package.clone()]).collect()
}

/// Names of the workspace's packages that have tests for the browser, sorted.
fn tested_on_wasm() -> Result<Vec<String>> {
    let folder = workspace::root().join("crates");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(&folder).doing("listing the crates")?.flatten() {
        let Ok(manifest) = std::fs::read_to_string(entry.path().join("Cargo.toml")) else { continue };
        if manifest.contains("wasm-bindgen-test") {
            found.push(format!("rosto-{}", entry.file_name().to_string_lossy()));
        }
    }
    found.sort();
    Ok(found)
}
