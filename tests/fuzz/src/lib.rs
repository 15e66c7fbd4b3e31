//! The files that others write and Rosto reads: valid seeds of every kind, their readers, and what every reader promises.

mod readers;
mod repair;
mod seeds;

use std::time::{Duration, Instant};

use peak_alloc::PeakAlloc;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// JPEG, PNG or WebP.
    Picture,
    /// An ICC profile.
    Profile,
    /// A GLB with what opens it again.
    Glb,
    /// A project file.
    Project,
    /// A history of edits.
    Edits,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Picture, Self::Profile, Self::Glb, Self::Project, Self::Edits];

    /// Valid files, small where they can be.
    pub fn seeds(self) -> Vec<Vec<u8>> {
        match self {
            Self::Picture => seeds::pictures::all(),
            Self::Profile => seeds::profiles::all(),
            Self::Glb => seeds::faces::glbs(),
            Self::Project => seeds::faces::projects(),
            Self::Edits => seeds::faces::histories().into_iter().map(String::into_bytes).collect(),
        }
    }

    /// Reads a file as the program does; returns whether it was accepted.
    ///
    /// # Panics
    ///
    /// If reading takes more than 2 s twice, holds more than 64 MB at a time, or breaks a promise.
    pub fn check(self, bytes: &[u8]) -> bool {
        let (accepted, took) = frugal(|| self.read(bytes));
        assert!(took < MOST_TIME || frugal(|| self.read(bytes)).1 < MOST_TIME, "reading takes {took:?}");
        accepted
    }

    fn read(self, bytes: &[u8]) -> bool {
        match self {
            Self::Picture => readers::picture(bytes),
            Self::Profile => readers::profile(bytes),
            Self::Glb => readers::glb(bytes),
            Self::Project => readers::project(bytes),
            Self::Edits => readers::edits(bytes),
        }
    }
}

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const MOST_TIME: Duration = Duration::from_secs(2);
const MOST_BYTES: usize = 64_000_000;

/// Runs `action` within the memory that a reader may hold; returns how long it took, too.
fn frugal<T>(action: impl FnOnce() -> T) -> (T, Duration) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let started = Instant::now();
    let outcome = action();
    let took = started.elapsed();
    let held = MEMORY.peak_usage().saturating_sub(before);
    assert!(held <= MOST_BYTES, "reading holds {held} bytes");
    (outcome, took)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_seed_is_accepted_by_its_reader() {
        for kind in Kind::ALL {
            for (which, seed) in kind.seeds().iter().enumerate() {
                assert!(kind.check(seed), "{kind:?} {which}");
            }
        }
    }

    #[test]
    #[should_panic(expected = "reading holds 70")]
    fn memory_that_was_given_back_counts_too() {
        frugal(|| drop(std::hint::black_box(vec![1_u8; 70_000_000])));
    }
}
