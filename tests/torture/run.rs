//! The run: every core takes inputs by number until there are enough or the time is over.

use std::fs::File;
use std::io::{Seek, Write};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::case::Case;
use crate::findings::{Failure, Findings};
use crate::kinds::{Kind, Verdict};
use crate::seeds::Seeds;
use crate::watch::observe;

/// How much is to be done.
#[derive(Debug, Clone)]
pub struct Plan {
    pub seed: u64,
    pub inputs: u64,
    pub time: Option<Duration>,
    /// All kinds, if none.
    pub only: Option<Kind>,
}

/// What came of the inputs of one kind.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    pub accepted: u64,
    pub refused: u64,
    pub failed: u64,
    pub peak_bytes: usize,
    /// The longest times and whose they are, longest first.
    slowest: Vec<(Duration, u64)>,
}

/// One tally for each of [`Kind::ALL`].
pub type Tallies = [Tally; Kind::ALL.len()];

/// An input that never ends is given up, and the run with it.
const HANGS: Duration = Duration::from_secs(60);
/// Shares are out of so many inputs.
const ROUND: u64 = 100_000;
/// So many of the slowest inputs are read again: in a long run, the machine has been slow for some of them.
const SLOWEST: usize = 8;

/// Tortures; the folder takes findings, and says after an abort which input was being read.
pub fn run(plan: &Plan, seeds: &Seeds, findings: &Findings, folder: &Path) -> Tallies {
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let until = plan.time.map(|time| Instant::now() + time);
    let next = AtomicU64::new(0);
    let clocks: Vec<AtomicU64> = (0..workers).map(|_| AtomicU64::new(0)).collect();
    let epoch = Instant::now();
    let work = |worker: usize| {
        let mut tallies = Tallies::default();
        let mut log = Log::new(&folder.join(format!("running-{worker}")));
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= plan.inputs || until.is_some_and(|until| Instant::now() > until) {
                clocks[worker].store(0, Ordering::Relaxed);
                return tallies;
            }
            let kind = plan.only.unwrap_or_else(|| kind_of(number));
            if kind.seeds(seeds).is_empty() {
                continue;
            }
            log.write(kind, number);
            clocks[worker].store(epoch.elapsed().as_millis() as u64 + 1, Ordering::Relaxed);
            torture(plan.seed, kind, number, seeds, findings, &mut tallies[kind as usize]);
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..workers).map(|worker| scope.spawn(move || work(worker))).collect();
        while !threads.iter().all(|thread| thread.is_finished()) {
            std::thread::sleep(Duration::from_millis(100));
            give_up_if_hung(&clocks, epoch, folder);
        }
        let done = threads.into_iter().filter_map(|thread| thread.join().ok());
        done.fold(Tallies::default(), |all, one| std::array::from_fn(|kind| all[kind].plus(&one[kind])))
    })
}

fn torture(run: u64, kind: Kind, number: u64, seeds: &Seeds, findings: &Findings, tally: &mut Tally) {
    let case = Case::new(run, kind, number, seeds);
    let bytes = case.bytes(seeds);
    let seen = observe(|| kind.read(&bytes, seeds));
    if seen.outcome.is_ok() {
        // What a panic holds and how long it takes is mostly the search for its stack.
        tally.peak_bytes = tally.peak_bytes.max(seen.peak_bytes);
        tally.keep_slow(seen.took, number);
    }
    match Failure::of(kind, &bytes, seeds, &seen) {
        Some(failure) => {
            tally.failed += 1;
            findings.add(&case, &bytes, &failure, seeds);
        }
        None if matches!(seen.outcome, Ok(Verdict::Accepted)) => tally.accepted += 1,
        None => tally.refused += 1,
    }
}

/// Kinds take turns so that a run that is cut short has seen all of them in their shares.
fn kind_of(number: u64) -> Kind {
    // Shares no factor with the length of a round, so that every place comes once in it.
    let mut place = number.wrapping_mul(61_803) % ROUND;
    for kind in Kind::ALL {
        match place.checked_sub(kind.share()) {
            Some(rest) => place = rest,
            None => return kind,
        }
    }
    Kind::Jpeg
}

fn give_up_if_hung(clocks: &[AtomicU64], epoch: Instant, folder: &Path) {
    let now = epoch.elapsed();
    for (worker, clock) in clocks.iter().enumerate() {
        let started = clock.load(Ordering::Relaxed);
        if started > 0 && now > Duration::from_millis(started) + HANGS {
            eprintln!("✗ an input takes more than {} s: {}/running-{worker}", HANGS.as_secs(), folder.display());
            std::process::exit(3);
        }
    }
}

impl Tally {
    pub fn inputs(&self) -> u64 {
        self.accepted + self.refused + self.failed
    }

    /// How long the slowest input takes, each of the slowest read again and timed at its best.
    pub fn slowest(&self, plan: &Plan, kind: Kind, seeds: &Seeds) -> Duration {
        let best = |number: u64| {
            let bytes = Case::new(plan.seed, kind, number, seeds).bytes(seeds);
            (0..3).map(|_| observe(|| kind.read(&bytes, seeds)).took).min()
        };
        self.slowest.iter().filter_map(|&(_, number)| best(number)).max().unwrap_or_default()
    }

    fn keep_slow(&mut self, took: Duration, number: u64) {
        if self.slowest.len() == SLOWEST && self.slowest.last().is_some_and(|&(least, _)| took <= least) {
            return;
        }
        self.slowest.push((took, number));
        self.slowest.sort_by_key(|&(took, _)| std::cmp::Reverse(took));
        self.slowest.truncate(SLOWEST);
    }

    fn plus(&self, other: &Self) -> Self {
        let mut sum = Self {
            accepted: self.accepted + other.accepted,
            refused: self.refused + other.refused,
            failed: self.failed + other.failed,
            peak_bytes: self.peak_bytes.max(other.peak_bytes),
            slowest: self.slowest.clone(),
        };
        other.slowest.iter().for_each(|&(took, number)| sum.keep_slow(took, number));
        sum
    }
}

/// Says which input is being read, so that an abort (a stack that overflows, memory that is refused) can be told.
struct Log(Option<File>);

impl Log {
    fn new(path: &Path) -> Self {
        Self(File::create(path).ok())
    }

    fn write(&mut self, kind: Kind, number: u64) {
        if let Some(file) = &mut self.0 {
            // A log that cannot be written takes nothing away from the run.
            let _ = file.rewind().and_then(|()| writeln!(file, "{:<10}{number:>20}", kind.name()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_its_share_of_a_round() {
        for kind in Kind::ALL {
            let count = (0..ROUND).filter(|&number| kind_of(number) == kind).count();
            assert_eq!(count as u64, kind.share(), "{}", kind.name());
        }
    }
}
