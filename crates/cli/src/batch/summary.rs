use std::path::Path;

use super::Skipped;
use crate::error::CliError;

/// Counts of a batch's outcomes.
#[derive(Default)]
pub struct BatchSummary {
    with_faces: usize,
    without: usize,
    failed: usize,
    failed_by_networks: usize,
}

impl BatchSummary {
    /// Counts a photo by whether it has a face, or as failed.
    pub fn count(&mut self, outcome: Result<&bool, &CliError>) {
        match outcome {
            Ok(true) => self.with_faces += 1,
            Ok(false) | Err(CliError::NoFace { .. }) => self.without += 1,
            Err(error) => {
                self.failed += 1;
                self.failed_by_networks += usize::from(error.is_network_failure());
            }
        }
    }

    /// One-line summary; `done` photos were complete before this run.
    pub fn text(&self, path: &Path, done: usize, skipped: &Skipped) -> String {
        let Self { with_faces, without, failed, .. } = self;
        let before = if done > 0 { format!("; {done} already done") } else { String::new() };
        let path = path.display();
        let skipped = skipped.summary();
        format!("{path}: {with_faces} photos with a face, {without} without, {failed} failed{before}{skipped}")
    }

    /// The error of the batch, if photos failed.
    pub fn verdict(&self) -> Result<(), CliError> {
        match (self.failed, self.failed_by_networks) {
            (0, _) => Ok(()),
            (count, 0) => Err(CliError::SomePhotosFailed { count }),
            (count, by_networks) => Err(CliError::NetworksFailed { count, by_networks }),
        }
    }
}
