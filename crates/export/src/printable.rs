//! The body that is printed.

use std::fmt;
use std::str::FromStr;

use glam::DVec3;
use rosto_mesh::Surface;
use rosto_solid::{Body, Closing};

use crate::model::MM_PER_M;
use crate::{ExportError, Model};

/// What a printer is given. Written as `thickness:2`, `flat:3`, `surface`, as on the command line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Solid {
    /// A wall so many mm thick.
    Thickness {
        /// How thick.
        mm: f64,
    },
    /// A relief with a flat back so many mm behind its deepest point.
    FlatBack {
        /// How far behind.
        mm: f64,
    },
    /// The surface alone, which is no body and cannot be printed as it is.
    Surface,
}

/// What a wall may measure in mm: a nozzle's width at least.
pub const SOLID_MM: [f64; 2] = [0.4, 50.0];

impl Default for Solid {
    /// A wall that is firm in plastic, and no heavier than it must be.
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

/// Why a text names no solid.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{text:?} is none of thickness:MM, flat:MM and surface, with MM from {} to {}", SOLID_MM[0], SOLID_MM[1])]
pub struct NoSolid {
    /// The text.
    pub text: String,
}

impl FromStr for Solid {
    type Err = NoSolid;

    fn from_str(text: &str) -> Result<Self, NoSolid> {
        let [least, most] = SOLID_MM;
        let length = |mm: &str| mm.parse().ok().filter(|mm: &f64| (least..=most).contains(mm));
        let found = match text.split_once(':') {
            Some(("thickness", mm)) => length(mm).map(|mm| Self::Thickness { mm }),
            Some(("flat", mm)) => length(mm).map(|mm| Self::FlatBack { mm }),
            None if text == "surface" => Some(Self::Surface),
            _ => None,
        };
        found.ok_or_else(|| NoSolid { text: text.to_owned() })
    }
}

impl Solid {
    /// The body that is made of a model so; none for the surface alone.
    ///
    /// # Errors
    /// [`ExportError`] if a length does not fit, a position is not finite, there is no triangle, or no such body can be made.
    pub fn body(self, model: &Model<'_>) -> Result<Option<Body>, ExportError> {
        model.check()?;
        let closing = match self {
            Self::Surface => return Ok(None),
            Self::Thickness { mm } => Closing::Thickness { thickness_m: mm / MM_PER_M },
            Self::FlatBack { mm } => Closing::FlatBack { thickness_m: mm / MM_PER_M },
        };
        let surface = Surface::new(model.topology, model.positions_m).map_err(rosto_solid::SolidError::from)?;
        let softer = model.softer_m.unwrap_or(model.positions_m);
        Ok(Some(Body::closed_or_softer(surface, softer, closing)?))
    }
}

/// What a printed body measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidFacts {
    /// What it encloses, in cm³.
    pub volume_cm3: f64,
    /// The sides of the box around it, in mm.
    pub size_mm: DVec3,
    /// How thick its wall is where it is thinnest, in mm.
    pub thinnest_mm: f64,
    /// How far the face was smoothed where it went through itself or left no room for the wall, in mm; 0 where neither was
    /// needed.
    pub moved_mm: f64,
}

impl SolidFacts {
    /// What is to be told of a body.
    pub fn of(body: &Body) -> Self {
        const CM3_PER_M3: f64 = 1e6;
        Self {
            volume_cm3: body.volume_m3() * CM3_PER_M3,
            size_mm: body.size_m() * MM_PER_M,
            thinnest_mm: body.thinnest_m() * MM_PER_M,
            moved_mm: body.moved_m() * MM_PER_M,
        }
    }

    /// What it weighs in g, filled with a material of that density in g/cm³.
    pub fn mass_g(&self, density_g_per_cm3: f64) -> f64 {
        self.volume_cm3 * density_g_per_cm3
    }
}
