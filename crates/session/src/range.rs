use serde::Serialize;
use tsify::Tsify;

/// Range of a number; sliders use it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct Range {
    /// Lower end.
    pub min: f64,
    /// Upper end.
    pub max: f64,
    /// Change per key press.
    pub step: f64,
    /// Initial value.
    pub neutral: f64,
}
