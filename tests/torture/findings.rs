//! What went wrong, once for each cause: named, shrunk, written to a file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use crate::case::Case;
use crate::kinds::{Kind, Verdict};
use crate::seeds::Seeds;
use crate::shrink::ddmin;
use crate::watch::{Observed, observe};

/// Reading any input takes less.
const MOST_TIME: Duration = Duration::from_secs(2);
/// How long is spent on making one input smaller.
const SHRINKING: Duration = Duration::from_secs(10);

/// Why an input is a finding.
#[derive(Debug, Clone)]
pub struct Failure {
    /// The same for the same cause.
    pub cause: String,
    /// Where it came from, as far as that is known.
    pub stack: String,
}

/// All findings of a run, by kind and cause.
#[derive(Debug, Default)]
pub struct Findings {
    found: Mutex<BTreeMap<(&'static str, String), Found>>,
    folder: PathBuf,
}

/// One cause.
#[derive(Debug, Clone)]
pub struct Found {
    pub inputs: u64,
    /// The first input, which the files are called after.
    pub number: u64,
}

/// The most memory in bytes that reading an input of this kind may hold at a time.
fn most_bytes(kind: Kind) -> usize {
    match kind {
        Kind::Detector | Kind::Landmarks => 512_000_000,
        _ => 64_000_000,
    }
}

impl Failure {
    /// Reads the input once more than it takes to be sure that it was not the machine that was slow.
    pub fn of(kind: Kind, bytes: &[u8], seeds: &Seeds, seen: &Observed<Verdict>) -> Option<Self> {
        let from = |cause: String| Some(Self { cause, stack: String::new() });
        match &seen.outcome {
            Err(panic) => {
                let cause = format!("panic at {}: {}", panic.place, without_numbers(&panic.message));
                return Some(Self { cause, stack: panic.stack.clone() });
            }
            Ok(Verdict::Broken(promise)) => return from(without_numbers(promise)),
            Ok(Verdict::Accepted | Verdict::Refused) => {}
        }
        if seen.peak_bytes > most_bytes(kind) {
            return from(format!("holds more than {} MB", most_bytes(kind) / 1_000_000));
        }
        let is_slow = seen.took > MOST_TIME && observe(|| kind.read(bytes, seeds)).took > MOST_TIME;
        if is_slow { from(format!("takes more than {} s", MOST_TIME.as_secs())) } else { None }
    }
}

impl Findings {
    /// Findings are written into this folder.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), ..Self::default() }
    }

    /// Takes a failure down; if it is the first with its cause, shrinks the input and writes it.
    pub fn add(&self, case: &Case, bytes: &[u8], failure: &Failure, seeds: &Seeds) {
        let key = (case.kind.name(), failure.cause.clone());
        let inputs = match self.found.lock() {
            Ok(mut found) => {
                let found = found.entry(key).or_insert(Found { inputs: 0, number: case.number });
                found.inputs += 1;
                found.inputs
            }
            Err(_) => return,
        };
        if inputs > 1 {
            return;
        }
        eprintln!("✗ {} {}: {}", case.kind.name(), case.number, failure.cause);
        let same = |bytes: &[u8]| {
            let seen = observe(|| case.kind.read(bytes, seeds));
            Failure::of(case.kind, bytes, seeds, &seen).is_some_and(|other| other.cause == failure.cause)
        };
        let fewer = case.shrunk(Instant::now() + SHRINKING, |fewer| same(&fewer.bytes(seeds)));
        let whole = fewer.bytes(seeds);
        let shorter = ddmin(whole.clone(), Instant::now() + SHRINKING, same);
        self.write(
            case,
            [bytes, &whole, &shorter],
            &format!("{}\n{}\n{}", failure.cause, fewer.describe(), failure.stack),
        );
    }

    /// How many causes a kind has.
    pub fn of(&self, kind: Kind) -> usize {
        self.all().iter().filter(|((name, _), _)| *name == kind.name()).count()
    }

    pub fn all(&self) -> BTreeMap<(&'static str, String), Found> {
        self.found.lock().map(|found| found.clone()).unwrap_or_default()
    }

    fn write(&self, case: &Case, [first, fewer, shorter]: [&[u8]; 3], report: &str) {
        let file = |end: &str| self.folder.join(format!("{}-{}{end}", case.kind.name(), case.number));
        let files = [(".first", first), (".fewer-changes", fewer), (".shorter", shorter), (".txt", report.as_bytes())];
        for (end, bytes) in files {
            if let Err(error) = std::fs::write(file(end), bytes) {
                eprintln!("{}: {error}", file(end).display());
            }
        }
    }
}

/// Messages tell sizes and places, which differ from input to input.
fn without_numbers(message: &str) -> String {
    let mut out = String::new();
    for character in message.chars() {
        let shown = if character.is_ascii_digit() { '#' } else { character };
        if !(shown == '#' && out.ends_with('#')) {
            out.push(shown);
        }
    }
    out
}
