use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::error::CliError;
use crate::terminal;

/// How far the photos are, on a terminal that nothing else is written to.
pub struct Progress(ProgressBar);

impl Progress {
    /// Of so many photos, some of which were done before. On standard output, lines of results show progress themselves.
    pub fn new(photos: usize, done: usize, lines_on_output: bool) -> Self {
        let is_shown = photos > 1 && !(lines_on_output && io::stdout().is_terminal());
        let target = if is_shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(photos as u64), target).with_position(done as u64);
        let style = ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len}, {per_sec}, {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        // What was done before says nothing of how long the rest takes.
        bar.reset_eta();
        Self(bar)
    }

    /// One more is done.
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
