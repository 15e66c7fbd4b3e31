//! How many tests passed and failed, read from what the runners print.

/// Numbers of tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Tests that passed.
    pub passed: usize,
    /// Tests that failed.
    pub failed: usize,
}

impl Counts {
    /// The sum of both.
    pub fn plus(self, other: Self) -> Self {
        Self { passed: self.passed + other.passed, failed: self.failed + other.failed }
    }

    /// One check that succeeded or did not.
    pub fn of_one(success: bool) -> Self {
        Self { passed: usize::from(success), failed: usize::from(!success) }
    }

    /// What a test runner's output and exit status say together.
    ///
    /// A runner that fails without a failed test (it did not compile, or died) counts as one failure, and so does one
    /// that ran no test at all.
    pub fn of_runner(success: bool, output: &str) -> Self {
        let counts = read(output);
        let silent_failure = counts.failed == 0 && (!success || counts.passed == 0);
        counts.plus(Self { passed: 0, failed: usize::from(silent_failure) })
    }
}

/// Sums the closing lines of libtest and wasm-bindgen-test, nextest, node's runner, and plain `N passed, N failed`.
pub fn read(output: &str) -> Counts {
    let lines = plain_lines(output);
    // nextest repeats what a failing test printed, libtest's closing line included: its own summary has them all.
    let summarised = lines.iter().any(|line| is_summary(line));
    let counted = lines.iter().filter(|line| !summarised || is_summary(line));
    counted.map(|line| of_line(line)).fold(Counts::default(), Counts::plus)
}

/// The tests that failed, by nextest's, libtest's and wasm-bindgen-test's lines, or by `✗ name` with the line after it.
pub fn failing(output: &str) -> Vec<String> {
    let lines = plain_lines(output);
    let summarised = lines.iter().any(|line| is_summary(line));
    let after = lines.iter().skip(1).map(String::as_str).chain([""]);
    let named = lines.iter().zip(after).filter_map(|(line, next)| {
        let of_one = line.strip_prefix("✗ ").map(|name| format!("{name}: {next}"));
        let of_nextest = || Some(line.strip_prefix("FAIL [")?.split_once(") ")?.1.to_owned());
        let of_libtest = || Some(line.strip_prefix("test ")?.split_once(" ... FAIL")?.0.to_owned());
        of_one.or_else(of_nextest).or_else(|| if summarised { None } else { of_libtest() })
    });
    // nextest names what failed when it happens and at its end.
    let mut once: Vec<String> = named.collect();
    once.sort();
    once.dedup();
    once
}

fn of_line(line: &str) -> Counts {
    if line.starts_with("test result:") || is_summary(line) || is_plain(line) {
        return Counts { passed: before(line, "passed"), failed: before(line, "failed") + before(line, "timed out") };
    }
    match line.trim_start_matches(['#', 'ℹ']).trim().split_once(' ') {
        Some(("pass", number)) if line.starts_with(['#', 'ℹ']) => {
            Counts { passed: number.parse().unwrap_or(0), failed: 0 }
        }
        Some(("fail", number)) if line.starts_with(['#', 'ℹ']) => {
            Counts { passed: 0, failed: number.parse().unwrap_or(0) }
        }
        _ => Counts::default(),
    }
}

fn plain_lines(output: &str) -> Vec<String> {
    output.lines().map(|line| without_colour(line).trim().to_owned()).collect()
}

fn is_summary(line: &str) -> bool {
    line.starts_with("Summary [")
}

/// `3 passed, 1 failed`, perhaps with the runner's name and a colon before it.
fn is_plain(line: &str) -> bool {
    let line = line.split_once(": ").map_or(line, |(_, counts)| counts);
    line.starts_with(|first: char| first.is_ascii_digit()) && line.contains(" passed, ") && line.contains(" failed")
}

/// The number in front of a word, 0 if the word is not there.
fn before(line: &str, word: &str) -> usize {
    let Some(at) = line.find(&format!(" {word}")) else { return 0 };
    let number = line[..at].rsplit(|c: char| !c.is_ascii_digit()).next().unwrap_or("");
    number.parse().unwrap_or(0)
}

fn without_colour(line: &str) -> String {
    let mut parts = line.split('\u{1b}');
    let first = parts.next().unwrap_or("").to_owned();
    parts.fold(first, |text, part| text + part.split_once('m').map_or("", |(_, rest)| rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_the_closing_lines_of_libtest() {
        let output = "running 3 tests\n\
            test result: ok. 3 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s\n\
            test result: FAILED. 4 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.01s\n";
        assert_eq!(read(output), Counts { passed: 7, failed: 2 });
    }

    #[test]
    fn reads_nextest() {
        let output = "     Summary [   0.025s] 31 tests run: 28 passed (1 slow), 2 failed, 1 timed out, 4 skipped";
        assert_eq!(read(output), Counts { passed: 28, failed: 3 });
        assert_eq!(read("     Summary [   0.02s] 8 tests run: 8 passed, 0 skipped"), Counts { passed: 8, failed: 0 });
    }

    #[test]
    fn what_a_failing_test_printed_under_nextest_is_not_counted_again() {
        let output = "    test result: FAILED. 0 passed; 1 failed; 0 ignored; 0 measured; 9 filtered out\n\
            \u{20}    Summary [  19.328s] 288 tests run: 287 passed, 1 failed, 0 skipped\n";
        assert_eq!(read(output), Counts { passed: 287, failed: 1 });
    }

    #[test]
    fn what_failed_is_named_once_by_every_runner() {
        let nextest = "  FAIL [   4.666s] ( 56/790) rosto-cli::photo keeps_its_pixels\n\
            test keeps_its_pixels ... FAILED\n  Summary [ 19.3s] 2 tests run: 1 passed, 1 failed, 0 skipped\n\
            \u{1b}[31m  FAIL\u{1b}[0m [   4.666s] ( 56/790) rosto-cli::photo keeps_its_pixels\n";
        assert_eq!(failing(nextest), ["rosto-cli::photo keeps_its_pixels"]);
        assert_eq!(failing("test a::b ... FAILED\ntest a::c ... ok\n"), ["a::b"]);
        assert_eq!(failing("✓ one (1 s)\n✗ a face (2 s)\n    Error: none\n"), ["a face (2 s): Error: none"]);
    }

    #[test]
    fn reads_node_in_both_reporters() {
        assert_eq!(read("# tests 5\n# pass 4\n# fail 1\n"), Counts { passed: 4, failed: 1 });
        assert_eq!(read("ℹ tests 5\nℹ pass 4\nℹ fail 1\n"), Counts { passed: 4, failed: 1 });
    }

    #[test]
    fn reads_the_plain_line_through_colours() {
        assert_eq!(read("\u{1b}[32m12 passed, 1 failed\u{1b}[0m"), Counts { passed: 12, failed: 1 });
        assert_eq!(read("journeys: 9 passed, 0 failed"), Counts { passed: 9, failed: 0 });
    }

    #[test]
    fn a_runner_that_fails_silently_or_runs_nothing_has_failed() {
        assert_eq!(Counts::of_runner(false, "error: could not compile"), Counts { passed: 0, failed: 1 });
        assert_eq!(Counts::of_runner(true, "0 passed, 0 failed"), Counts { passed: 0, failed: 1 });
        assert_eq!(Counts::of_runner(true, "2 passed, 0 failed"), Counts { passed: 2, failed: 0 });
        assert_eq!(Counts::of_runner(false, "2 passed, 1 failed"), Counts { passed: 2, failed: 1 });
    }
}
