//! Rosto's readers of untrusted files: valid seeds of each kind, and the requirements that a reader must meet.

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
    /// A GLB that can be reopened.
    Glb,
    /// A project file.
    Project,
    /// A history of edits, as JSON.
    Edits,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Picture, Self::Profile, Self::Glb, Self::Project, Self::Edits];

    /// Small valid files.
    pub fn seeds(self) -> Vec<Vec<u8>> {
        match self {
            Self::Picture => seeds::pictures::all(),
            Self::Profile => seeds::profiles::all(),
            Self::Glb => seeds::faces::glbs(),
            Self::Project => seeds::faces::projects(),
            Self::Edits => seeds::faces::histories().into_iter().map(String::into_bytes).collect(),
        }
    }

    /// Reads a file as Rosto does; returns whether it was accepted.
    ///
    /// # Panics
    ///
    /// If reading takes more than 2 s in two attempts, allocates more than 64 MB, or violates a requirement.
    pub fn check(self, bytes: &[u8]) -> bool {
        let (accepted, took) = measured(|| self.read(bytes));
        assert!(took < MAX_TIME || measured(|| self.read(bytes)).1 < MAX_TIME, "reading takes {took:?}");
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

const MAX_TIME: Duration = Duration::from_secs(2);
const MAX_BYTES: usize = 64_000_000;

/// Runs `action`, asserts its memory limit, and returns its result and duration.
fn measured<T>(action: impl FnOnce() -> T) -> (T, Duration) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let started = Instant::now();
    let outcome = action();
    let took = started.elapsed();
    let held = MEMORY.peak_usage().saturating_sub(before);
    assert!(held <= MAX_BYTES, "reading allocates {held} bytes");
    (outcome, took)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_accept_their_seeds() {
        for kind in Kind::ALL {
            for (which, seed) in kind.seeds().iter().enumerate() {
                assert!(kind.check(seed), "{kind:?} {which}");
            }
        }
    }

    #[test]
    #[should_panic(expected = "reading allocates 7")]
    fn counts_memory_that_was_freed() {
        measured(|| drop(std::hint::black_box(vec![1_u8; 70_000_000])));
    }
}
