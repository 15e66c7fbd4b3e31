//! Printable bodies.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use rosto_mesh::Surface;
use rosto_solid::{Body, Closing};

use crate::model::MM_PER_M;
use crate::{ExportError, Model};

/// Shape of the printable body. Its text form is `thickness:2`, `flat:3` or `surface`, as on the command line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solid {
    /// A wall of constant thickness.
    Thickness {
        /// Thickness in mm.
        mm: f64,
    },
    /// A relief with a flat back.
    FlatBack {
        /// Distance from the deepest point to the back, in mm.
        mm: f64,
    },
    /// The open surface, which cannot be printed as it is.
    Surface,
}

/// Range of the thickness in mm; the minimum is a nozzle's width.
pub const SOLID_MM: [f64; 2] = [0.4, 50.0];

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
            Self::FlatBack { mm } => write!(f, "flat:{mm}"),
            Self::Surface => write!(f, "surface"),
        }
    }
}

/// Error for a text that is not a [`Solid`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{text:?} is not one of thickness:MM, flat:MM and surface, with MM from {} to {}", SOLID_MM[0], SOLID_MM[1])]
pub struct ParseSolidError {
    /// The rejected text.
    pub text: String,
}

impl FromStr for Solid {
    type Err = ParseSolidError;

    fn from_str(text: &str) -> Result<Self, ParseSolidError> {
        let [least, most] = SOLID_MM;
        let length = |mm: &str| mm.parse().ok().filter(|mm: &f64| (least..=most).contains(mm));
        let found = match text.split_once(':') {
            Some(("thickness", mm)) => length(mm).map(|mm| Self::Thickness { mm }),
            Some(("flat", mm)) => length(mm).map(|mm| Self::FlatBack { mm }),
            None if text == "surface" => Some(Self::Surface),
            _ => None,
        };
        found.ok_or_else(|| ParseSolidError { text: text.to_owned() })
    }
}

impl Solid {
    /// Makes the body from a model; `None` for [`Self::Surface`].
    ///
    /// # Errors
    /// [`ExportError`] if a length does not match, a position is not finite, the mesh is empty, or the body cannot be
    /// made.
    pub fn body(self, model: &Model<'_>) -> Result<Option<Body>, ExportError> {
        model.check()?;
        let closing = match self {
            Self::Surface => return Ok(None),
            Self::Thickness { mm } => Closing::Thickness { thickness_m: mm / MM_PER_M },
            Self::FlatBack { mm } => Closing::FlatBack { thickness_m: mm / MM_PER_M },
        };
        let surface = Surface::new(model.topology, model.positions_m).map_err(rosto_solid::SolidError::from)?;
        let smoothed = model.smoothed_m.unwrap_or(model.positions_m);
        Ok(Some(Body::closed_or_smoothed(surface, smoothed, closing)?))
    }
}

/// Measurements of a printable body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidFacts {
    /// Enclosed volume in cm³.
    pub volume_cm3: f64,
    /// Size of the bounding box in mm.
    pub size_mm: DVec3,
    /// Smallest wall thickness in mm.
    pub thinnest_mm: f64,
    /// Largest displacement by smoothing, in mm, where the face intersected itself or left no room for the wall; 0 if
    /// there was no smoothing.
    pub moved_mm: f64,
}

impl SolidFacts {
    /// Measures a body.
    pub fn of(body: &Body) -> Self {
        const CM3_PER_M3: f64 = 1e6;
        Self {
            volume_cm3: body.volume_m3() * CM3_PER_M3,
            size_mm: body.size_m() * MM_PER_M,
            thinnest_mm: body.thinnest_m() * MM_PER_M,
            moved_mm: body.moved_m() * MM_PER_M,
        }
    }

    /// Mass in g when filled with a material of the given density.
    pub fn mass_g(&self, density_g_per_cm3: f64) -> f64 {
        self.volume_cm3 * density_g_per_cm3
    }
}
