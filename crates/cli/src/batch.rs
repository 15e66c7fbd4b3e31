//! Batches: lists photos, processes them in parallel, and returns results in order.

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

/// Result for one photo.
pub type Outcome<T> = (PathBuf, Result<T, CliError>);

/// Results that each thread may queue while an earlier photo is still in progress. Bounds memory regardless of the
/// number of photos.
const MAX_QUEUED: usize = 64;

/// Processes the photos in `jobs` threads and passes the results to `take` in the order of the photos. Stops at the
/// first error of `take`. A panic counts as an error of its photo.
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
        // Photo i goes to thread i mod jobs. A closed channel means that its thread panicked.
        let mut outcomes = (0..photos.len()).map_while(|photo| lanes[photo % jobs].recv().ok());
        outcomes.try_for_each(&mut take)
    })
}

fn in_a_thread<'scope, 'env, T: Send + 'scope>(
    scope: &'scope Scope<'scope, 'env>,
    photos: impl Iterator<Item = &'env PathBuf> + Send + 'scope,
    work: &'scope (impl Fn(&Path) -> Result<T, CliError> + Sync),
) -> Receiver<Outcome<T>> {
    let (sender, receiver) = sync_channel(MAX_QUEUED);
    scope.spawn(move || {
        for photo in photos {
            let worked = panic::catch_unwind(AssertUnwindSafe(|| work(photo)));
            let outcome = worked.unwrap_or_else(|_| Err(CliError::InternalError { path: photo.clone() }));
            // The receiver is gone: `take` returned an error.
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
    fn results_keep_the_order_of_the_photos() {
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
    fn a_panic_on_one_photo_does_not_stop_the_others() {
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
    fn the_queue_is_bounded_and_an_error_stops_the_batch() {
        let photos = named(100_000);
        let worked = AtomicUsize::new(0);
        let work = |_: &Path| {
            worked.fetch_add(1, Ordering::Relaxed);
            Ok(())
        };
        let refused = in_order(&photos, 2, work, |_| Err(CliError::StandardInputTwice));
        assert!(refused.is_err());
        assert!(worked.into_inner() <= 2 * (MAX_QUEUED + 2));
    }
}
