//! A session as restless visitors use it, and as careful ones do.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod choices;
mod faces;
mod intents;
mod invariants;
mod live_preview;
mod random;
mod refusals;
mod taken_from;
mod walks;
