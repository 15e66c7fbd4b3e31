//! The paper's experiment: three vertices of known degree, moved a little and then a lot, with random anchors.
//!
//! It works on a face's landmarks in image coordinates, as the paper does, and apart from any [`Document`](crate::Document).
//! The clock is the caller's: [`Trial::edit`] does one edit from nothing and changes nothing, so that it can be repeated
//! until it can be timed; [`Trial::go_on`] keeps its result with the time that was measured.

mod claims;
mod experiment;
mod plot;
mod spread;
mod table;

pub use claims::{Claims, MethodOutcome, spread_ms};
pub use experiment::{DEGREES, Experiment, Method, OFFSETS, Plan, TimedEdit, Trial};
pub use plot::{PlotWords, svg};
pub use spread::Spread;
pub use table::{TABLE_1, TableRow, Task};
