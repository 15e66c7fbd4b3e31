//! Valid files of each kind.

pub mod faces;
pub mod pictures;
pub mod profiles;
