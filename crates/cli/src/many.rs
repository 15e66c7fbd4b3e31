//! Many photos: listed, worked on side by side, and taken in their order.

mod journal;
mod lines;
mod listing;
mod name;
mod progress;
mod summary;

use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::{self, Scope};

use crate::error::CliError;

pub use journal::Journal;
pub use lines::{Lines, Verdict};
pub use listing::{Listed, Listing, Skipped, photos};
pub use name::{PhotoName, hex};
pub use progress::Progress;
pub use summary::BatchSummary;

/// What came of a photo.
pub type Outcome<T> = (PathBuf, Result<T, CliError>);

/// So many results of each thread wait to be taken while an earlier photo takes its time: memory does not grow with photos.
const MOST_WAITING: usize = 64;

/// Works on the photos in so many threads, and hands what comes of them to `take` in their order, as it comes; ends with the
/// first that `take` refuses. A photo that breaks the program is as bad as any other.
pub fn in_order<T: Send>(
    photos: &[PathBuf],
    jobs: usize,
    work: impl Fn(&Path) -> Result<T, CliError> + Sync,
    mut take: impl FnMut(Outcome<T>) -> Result<(), CliError>,
) -> Result<(), CliError> {
    let jobs = jobs.clamp(1, photos.len().max(1));
    thread::scope(|scope| {
        let lanes: Vec<Receiver<Outcome<T>>> = (0..jobs)
            .map(|lane| {
                let own = photos.iter().skip(lane).step_by(jobs);
                in_a_thread(scope, own, &work)
            })
            .collect();
        // Photos are dealt out in turn, and taken back so; a thread that ends early has said why.
        let mut outcomes = (0..photos.len()).map_while(|photo| lanes[photo % jobs].recv().ok());
        outcomes.try_for_each(&mut take)
    })
}

fn in_a_thread<'scope, 'env, T: Send + 'scope>(
    scope: &'scope Scope<'scope, 'env>,
    photos: impl Iterator<Item = &'env PathBuf> + Send + 'scope,
    work: &'scope (impl Fn(&Path) -> Result<T, CliError> + Sync),
) -> Receiver<Outcome<T>> {
    let (sender, receiver) = sync_channel(MOST_WAITING);
    scope.spawn(move || {
        for photo in photos {
            let worked = panic::catch_unwind(AssertUnwindSafe(|| work(photo)));
            let outcome = worked.unwrap_or_else(|_| Err(CliError::Broke { path: photo.clone() }));
            // Nobody takes any more: the rest is left.
            if sender.send((photo.clone(), outcome)).is_err() {
                break;
            }
        }
    });
    receiver
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    fn named(count: usize) -> Vec<PathBuf> {
        (0..count).map(|photo| PathBuf::from(photo.to_string())).collect()
    }

    fn number(path: &Path) -> usize {
        path.to_string_lossy().parse().unwrap()
    }

    #[test]
    fn what_comes_is_in_order_whoever_is_slow() {
        let photos = named(100);
        for jobs in [1, 3, 8, 200] {
            let mut taken = Vec::new();
            let work = |path: &Path| {
                thread::sleep(Duration::from_micros((number(path) * 7919 % 5) as u64 * 100));
                Ok(number(path))
            };
            let take = |(_, outcome): Outcome<usize>| {
                taken.push(outcome?);
                Ok(())
            };
            in_order(&photos, jobs, work, take).unwrap();
            assert_eq!(taken, (0..100).collect::<Vec<_>>(), "{jobs} jobs");
        }
    }

    #[test]
    fn a_photo_that_breaks_the_program_stops_no_other() {
        let photos = named(10);
        let mut bad = Vec::new();
        let work = |path: &Path| if number(path) == 4 { panic!("planted") } else { Ok(()) };
        let take = |(path, outcome): Outcome<()>| {
            bad.extend(outcome.err().map(|_| path));
            Ok(())
        };
        in_order(&photos, 2, work, take).unwrap();
        assert_eq!(bad, [PathBuf::from("4")]);
    }

    #[test]
    fn no_more_waits_than_there_is_room_for_and_a_refusal_ends_it() {
        let photos = named(100_000);
        let worked = AtomicUsize::new(0);
        let work = |_: &Path| {
            worked.fetch_add(1, Ordering::Relaxed);
            Ok(())
        };
        let refused = in_order(&photos, 2, work, |_| Err(CliError::StandardInputTwice));
        assert!(refused.is_err());
        assert!(worked.into_inner() <= 2 * (MOST_WAITING + 2));
    }
}
