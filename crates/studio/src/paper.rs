//! The paper's experiment: three vertices of given degree, moved by a small and a large offset, with random anchors.
//!
//! It uses a face's landmarks in image coordinates, as the paper does, and no [`Document`](crate::Document). The caller
//! measures the time: [`Trial::edit`] performs one edit from scratch without changing the trial, so that it can be
//! repeated for timing; [`Trial::go_on`] records the result and its time.

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
