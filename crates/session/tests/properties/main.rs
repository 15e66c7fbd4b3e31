//! Property tests and scenarios of a session.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod choices;
mod faces;
mod intents;
mod invariants;
mod live_preview;
mod messages;
mod panel_texts;
mod panels;
mod photo_lens;
mod printing;
mod random;
mod refusals;
mod rendering;
mod scenarios;
