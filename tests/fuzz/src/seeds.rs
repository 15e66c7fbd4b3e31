//! Valid files of every kind.

pub mod faces;
pub mod pictures;
pub mod profiles;
