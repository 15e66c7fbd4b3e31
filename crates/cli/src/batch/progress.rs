use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::error::CliError;
use crate::terminal;

/// Progress bar on standard error.
pub struct Progress(ProgressBar);

impl Progress {
    /// `photos` in total, of which `done` are complete. The bar is hidden if result lines go to the terminal.
    pub fn new(photos: usize, done: usize, lines_on_output: bool) -> Self {
        let is_shown = photos > 1 && !(lines_on_output && io::stdout().is_terminal());
        let target = if is_shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(photos as u64), target).with_position(done as u64);
        let style = ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len}, {per_sec}, {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        // Earlier runs must not affect the rate.
        bar.reset_eta();
        Self(bar)
    }

    /// Advances by one photo.
    pub fn step(&self) {
        self.0.inc(1);
    }

    /// Reports a photo that failed, above the bar.
    pub fn report(&self, error: &CliError) {
        self.0.suspend(|| error.report());
    }

    /// Writes notes above the bar.
    pub fn note(&self, notes: &[String]) {
        self.0.suspend(|| notes.iter().for_each(|note| terminal::note(note)));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
