use std::path::Path;

use super::Skipped;
use crate::error::CliError;

/// What came of the photos.
#[derive(Default)]
pub struct BatchSummary {
    with_faces: usize,
    without: usize,
    failed: usize,
    failed_by_networks: usize,
}

impl BatchSummary {
    /// Counts a photo by whether it has a face, or by why that is not known.
    pub fn count(&mut self, outcome: Result<&bool, &CliError>) {
        match outcome {
            Ok(true) => self.with_faces += 1,
            Ok(false) | Err(CliError::NoFace { .. }) => self.without += 1,
            Err(error) => {
                self.failed += 1;
                self.failed_by_networks += usize::from(error.is_of_networks());
            }
        }
    }

    /// In words; `done` photos were done before, and folders had files that are not photos.
    pub fn text(&self, path: &Path, done: usize, skipped: &Skipped) -> String {
        let Self { with_faces, without, failed, .. } = self;
        let before = if done > 0 { format!("; {done} were done before") } else { String::new() };
        let path = path.display();
        let skipped = skipped.summary();
        format!("{path}: {with_faces} photos with a face, {without} without, {failed} that failed{before}{skipped}")
    }

    /// A failure if there was one.
    pub fn verdict(&self) -> Result<(), CliError> {
        match (self.failed, self.failed_by_networks) {
            (0, _) => Ok(()),
            (count, 0) => Err(CliError::SomePhotosFailed { count }),
            (count, by_networks) => Err(CliError::NetworksFailed { count, by_networks }),
        }
    }
}
