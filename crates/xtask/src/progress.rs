//! What the terminal shows while something takes long.

use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

/// How often a running program's last line is shown where the output is a log, not a terminal.
const LOG_INTERVAL: Duration = Duration::from_secs(20);
const TERMINAL_INTERVAL: Duration = Duration::from_millis(250);
const LINE_WIDTH: usize = 96;

/// Announces something that takes a while: what it is and why it is needed.
pub fn announce(what: &str, why: &str) {
    println!("▸ {what} ({why})");
}

/// Says that something announced is done.
pub fn done(what: &str, since: Instant) {
    println!("  ✓ {what}, {}", elapsed(since.elapsed()));
}

/// Something the user should know that stops nothing.
pub fn note(text: &str) {
    println!("  · {text}");
}

/// A duration as a person says it: `0.4 s`, `12 s`, `3 min 05 s`.
pub fn elapsed(duration: Duration) -> String {
    let seconds = duration.as_secs_f64();
    match duration.as_secs() {
        0..10 => format!("{seconds:.1} s"),
        10..120 => format!("{seconds:.0} s"),
        whole => format!("{} min {:02} s", whole / 60, whole % 60),
    }
}

/// Shows the last line of a running program, overwriting itself on a terminal.
pub struct Ticker {
    started: Instant,
    shown: Instant,
    terminal: bool,
    dirty: bool,
}

impl Ticker {
    /// Starts counting now.
    pub fn new() -> Self {
        let now = Instant::now();
        Self { started: now, shown: now, terminal: std::io::stdout().is_terminal(), dirty: false }
    }

    /// Shows `last_line()` if it is time to.
    pub fn tick(&mut self, last_line: impl FnOnce() -> String) {
        let interval = if self.terminal { TERMINAL_INTERVAL } else { LOG_INTERVAL };
        if self.shown.elapsed() < interval {
            return;
        }
        self.shown = Instant::now();
        let line: String = last_line().trim().chars().take(LINE_WIDTH).collect();
        let text = format!("    {}  {line}", elapsed(self.started.elapsed()));
        if self.terminal {
            print!("\r\x1b[K{text}");
            self.dirty = true;
        } else {
            println!("{text}");
        }
        // Progress is a courtesy: a closed pipe must not end the work.
        let _ = std::io::stdout().flush();
    }
}

impl Drop for Ticker {
    fn drop(&mut self) {
        if self.dirty {
            print!("\r\x1b[K");
            let _ = std::io::stdout().flush();
        }
    }
}
