//! The one way in which a task fails: what could not be had, what was tried, and what the user can do.

use std::fmt;

/// Result of a task.
pub type Result<T = (), E = Failure> = std::result::Result<T, E>;

/// A failure that a person can act on.
#[derive(Debug)]
pub struct Failure {
    what: String,
    tried: Vec<String>,
    advice: Vec<String>,
}

impl Failure {
    /// A failure; `what` is a sentence that names the thing that could not be had or done.
    pub fn new(what: impl Into<String>) -> Self {
        Self { what: what.into(), tried: Vec::new(), advice: Vec::new() }
    }

    /// Adds something that was tried, with what came of it.
    pub fn tried(mut self, attempt: impl Into<String>) -> Self {
        self.tried.push(attempt.into());
        self
    }

    /// Adds something the user can do.
    pub fn advice(mut self, advice: impl Into<String>) -> Self {
        self.advice.push(advice.into());
        self
    }

    /// Adds every attempt of another failure that led to this one.
    pub fn because(mut self, cause: &Self) -> Self {
        self.tried.push(cause.what.clone());
        self.tried.extend(cause.tried.iter().cloned());
        self
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}", self.what)?;
        list(out, "tried", &self.tried)?;
        list(out, "what you can do", &self.advice)
    }
}

impl std::error::Error for Failure {}

fn list(out: &mut fmt::Formatter<'_>, title: &str, entries: &[String]) -> fmt::Result {
    if entries.is_empty() {
        return Ok(());
    }
    write!(out, "\n  {title}:")?;
    entries.iter().try_for_each(|entry| write!(out, "\n    - {}", entry.trim_end().replace('\n', "\n      ")))
}

/// Says what was being done when an input or output error happened.
pub trait Doing<T> {
    /// Turns the error into a [`Failure`] that begins with `doing`.
    fn doing(self, doing: impl fmt::Display) -> Result<T>;
}

impl<T, E: fmt::Display> Doing<T> for std::result::Result<T, E> {
    fn doing(self, doing: impl fmt::Display) -> Result<T> {
        self.map_err(|error| Failure::new(format!("{doing}: {error}")))
    }
}
