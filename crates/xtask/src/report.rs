//! Table of the steps with their times, and the slowest tests.

use crate::run::elapsed;
use std::time::Duration;

/// Number of tests listed.
const SLOWEST: usize = 12;

/// Result of a step.
pub struct Outcome {
    /// Name of the step.
    pub step: &'static str,
    /// Duration; none if the step passed in an earlier run.
    pub took: Option<Duration>,
    /// Output of its program, on failure as the error.
    pub output: Result<String, String>,
}

impl Outcome {
    /// A success without output.
    pub fn passed(step: &'static str, took: Option<Duration>) -> Self {
        Self { step, took, output: Ok(String::new()) }
    }
}

/// Table of all steps, then the slowest tests.
pub fn table(outcomes: &[Outcome], total: Duration) -> String {
    let mut lines: Vec<String> = outcomes.iter().map(row).collect();
    lines.push(format!("  {:<14} {:>12}", "total", elapsed(total)));
    let mut tests: Vec<_> = outcomes.iter().flat_map(tests).collect();
    tests.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    lines.push(String::new());
    lines.extend(tests.iter().take(SLOWEST).map(|(name, seconds)| format!("  {seconds:>6.1} s  {name}")));
    lines.join("\n")
}

fn row(outcome: &Outcome) -> String {
    let took = outcome.took.map_or("earlier".to_owned(), elapsed);
    let mark = if outcome.output.is_ok() { '✓' } else { '✗' };
    let counts = outcome.output.as_deref().ok().and_then(counts).unwrap_or_default();
    format!("{mark} {:<14} {took:>12}  {counts}", outcome.step).trim_end().to_owned()
}

/// The line with which a test runner ends, and the number of tests that passed only when they were repeated.
pub fn counts(output: &str) -> Option<String> {
    // cargo also prints such a line for each crate without tests.
    let passed = output.lines().rfind(|line| line.contains("passed") && !line.contains(" 0 passed"))?.trim();
    let flaky = output.lines().rfind(|line| line.trim().ends_with(" flaky"));
    Some(flaky.map_or(passed.to_owned(), |flaky| format!("{passed}, {}", flaky.trim())))
}

/// Names and seconds of the tests in a step's output.
fn tests(outcome: &Outcome) -> Vec<(String, f64)> {
    let (Ok(output) | Err(output)) = &outcome.output;
    let timed = output.lines().filter_map(|line| from_nextest(line).or_else(|| from_playwright(line)));
    timed.map(|(name, seconds)| (format!("{}: {name}", outcome.step), seconds)).collect()
}

/// `PASS [   0.012s] (1/900) crate::program test`
fn from_nextest(line: &str) -> Option<(&str, f64)> {
    let (seconds, name) = line.trim().strip_prefix("PASS [")?.split_once("s]")?;
    let name = name.trim_start().split_once(") ").map_or(name, |(_, name)| name);
    Some((name.trim(), seconds.trim().parse().ok()?))
}

/// `✓  12 [usual] › face.spec.mjs:10:1 › title (5.3s)`
fn from_playwright(line: &str) -> Option<(&str, f64)> {
    let (name, took) = line.trim().strip_prefix('✓')?.strip_suffix(')')?.rsplit_once(" (")?;
    let seconds = match took.strip_suffix("ms") {
        Some(number) => number.parse::<f64>().ok()? / 1000.0,
        None => match took.strip_suffix('m') {
            Some(minutes) => minutes.parse::<f64>().ok()? * 60.0,
            None => took.strip_suffix('s')?.parse().ok()?,
        },
    };
    let name = name.split_once("› ").map_or(name, |(_, name)| name);
    Some((name.trim(), seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_times_of_each_test_runner() {
        let nextest = "        PASS [  12.345s] (17/899) rosto-cli::batch resumes a folder";
        assert_eq!(from_nextest(nextest), Some(("rosto-cli::batch resumes a folder", 12.345)));
        let line = |took: &str| format!("  ✓  12 [usual] › face.spec.mjs:10:1 › both sides (first) ({took})");
        for (took, seconds) in [("5.3s", 5.3), ("512ms", 0.512), ("1.5m", 90.0)] {
            assert_eq!(from_playwright(&line(took)), Some(("face.spec.mjs:10:1 › both sides (first)", seconds)));
        }
        assert_eq!(from_playwright("  ✓ format, 1.2 s"), None);
    }

    #[test]
    fn lists_each_step_and_the_slowest_test_first() {
        let ran = |step, took, output: &str| Outcome { step, took, output: Ok(output.to_owned()) };
        let steps = [
            ran(
                "native",
                Some(Duration::from_secs(125)),
                "PASS [ 0.5s] a::b quick\nPASS [ 2.5s] a::b slow\n2 tests: 2 passed",
            ),
            ran("docs", None, ""),
            Outcome { step: "e2e", took: Some(Duration::from_secs(3)), output: Err(String::new()) },
        ];
        let shown = table(&steps, Duration::from_secs(130));
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[0], "✓ native           2 min 05 s  2 tests: 2 passed");
        assert_eq!(lines[1], "✓ docs                earlier");
        assert_eq!(lines[2], "✗ e2e                   3.0 s");
        assert_eq!(lines[3], "  total            2 min 10 s");
        assert_eq!(lines[5..], ["     2.5 s  native: a::b slow", "     0.5 s  native: a::b quick"]);
    }
}
