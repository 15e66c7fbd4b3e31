//! Choices for a print, with their texts.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;

use crate::model::MM_PER_M;

/// Shape of the printable body. Its text form is `thickness:2`, `flat:25`, `flat` or `surface`, as on the command line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solid {
    /// A wall of constant thickness.
    Thickness {
        /// Thickness in mm.
        mm: f64,
    },
    /// A relief with a flat back.
    FlatBack {
        /// Largest depth in mm, back included: a deeper face is compressed. `None` is a third of the height.
        depth_mm: Option<f64>,
    },
    /// The open surface, which cannot be printed as it is.
    Surface,
}

/// Range of the thickness in mm; the minimum is a nozzle's width.
pub const SOLID_MM: [f64; 2] = [0.4, 50.0];

/// Range of a relief's depth in mm; the minimum leaves as much for the face as for the back.
pub const DEPTH_MM: [f64; 2] = [2.0 * BACK_MM, 150.0];

/// Range of the printed height in mm.
pub const HEIGHT_MM: [f64; 2] = [10.0, 500.0];

/// Thickness of a relief behind its deepest point, in mm.
pub(super) const BACK_MM: f64 = 2.0;

/// Depth of a relief without a given one, relative to its height.
const DEPTH_SHARE: f64 = 1.0 / 3.0;

impl Default for Solid {
    /// A wall that is stable in plastic and still light.
    fn default() -> Self {
        Self::Thickness { mm: 2.0 }
    }
}

impl fmt::Display for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Thickness { mm } => write!(f, "thickness:{mm}"),
            Self::FlatBack { depth_mm: Some(mm) } => write!(f, "flat:{mm}"),
            Self::FlatBack { depth_mm: None } => write!(f, "flat"),
            Self::Surface => write!(f, "surface"),
        }
    }
}

/// Error for a text that is not a [`Solid`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "{text:?} is not one of thickness:MM, with MM from {} to {}, flat:MM, from {} to {}, flat and surface",
    SOLID_MM[0], SOLID_MM[1], DEPTH_MM[0], DEPTH_MM[1]
)]
pub struct ParseSolidError {
    /// The rejected text.
    pub text: String,
}

impl FromStr for Solid {
    type Err = ParseSolidError;

    fn from_str(text: &str) -> Result<Self, ParseSolidError> {
        let found = match text.split_once(':') {
            Some(("thickness", mm)) => length_mm(mm, SOLID_MM).map(|mm| Self::Thickness { mm }),
            Some(("flat", mm)) => length_mm(mm, DEPTH_MM).map(|mm| Self::FlatBack { depth_mm: Some(mm) }),
            None if text == "flat" => Some(Self::FlatBack { depth_mm: None }),
            None if text == "surface" => Some(Self::Surface),
            _ => None,
        };
        found.ok_or_else(|| ParseSolidError { text: text.to_owned() })
    }
}

fn length_mm(text: &str, [least, most]: [f64; 2]) -> Option<f64> {
    text.parse().ok().filter(|mm: &f64| (least..=most).contains(mm))
}

/// Height of a print. Its text form is `life` or a number of mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PrintHeight {
    /// That of the face.
    #[default]
    Life,
    /// In mm.
    Mm(f64),
}

impl fmt::Display for PrintHeight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Life => write!(f, "life"),
            Self::Mm(mm) => write!(f, "{mm}"),
        }
    }
}

/// Error for a text that is not a [`PrintHeight`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{text:?} is neither life nor a height from {} to {} mm", HEIGHT_MM[0], HEIGHT_MM[1])]
pub struct ParseHeightError {
    /// The rejected text.
    pub text: String,
}

impl FromStr for PrintHeight {
    type Err = ParseHeightError;

    fn from_str(text: &str) -> Result<Self, ParseHeightError> {
        let found = if text == "life" { Some(Self::Life) } else { length_mm(text, HEIGHT_MM).map(Self::Mm) };
        found.ok_or_else(|| ParseHeightError { text: text.to_owned() })
    }
}

impl PrintHeight {
    /// The height in mm of a print of a face at these positions, in metres.
    pub fn mm(self, face_m: &[DVec3]) -> f64 {
        match self {
            Self::Life => extent(face_m, 1) * MM_PER_M,
            Self::Mm(mm) => mm,
        }
    }
}

impl Solid {
    /// Depth in mm of a relief of this height, without a given one.
    pub fn usual_depth_mm(height_mm: f64) -> f64 {
        (DEPTH_SHARE * height_mm).clamp(DEPTH_MM[0], DEPTH_MM[1])
    }
}

/// Size along an axis.
pub(super) fn extent(positions: &[DVec3], axis: usize) -> f64 {
    let along = || positions.iter().map(|position| position[axis]);
    along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
}
