use glam::DVec3;
use rosto_solid::{Body, PLA_G_PER_CM3};

use super::Solid;
use super::choices::BACK_MM;
use crate::model::MM_PER_M;

rosto_mesh::named! {
    /// Orientation on the printer's bed.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum PrintPose {
        /// On its back, with the face up.
        Lying = "lying",
        /// Upright, on the chin.
        Upright = "upright",
    }
}

impl PrintPose {
    fn up(self) -> DVec3 {
        match self {
            Self::Lying => DVec3::Z,
            Self::Upright => DVec3::Y,
        }
    }
}

/// Measurements of a printable body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidFacts {
    /// Enclosed volume in cm³.
    pub volume_cm3: f64,
    /// Size of the bounding box in mm.
    pub size_mm: DVec3,
    /// Mass in g of a print in PLA, with shells of 1.2 mm and 15 % infill.
    pub pla_g: f64,
    /// Requested wall thickness in mm; that behind the deepest point for a relief.
    pub asked_mm: f64,
    /// Smallest wall thickness in mm.
    pub thinnest_mm: f64,
    /// Share of the front's area, 0 to 1, where the wall is notably thinner than requested: by more than 5 %.
    pub thin_share: f64,
    /// Largest displacement by smoothing, in mm, where the face intersected itself or left no room for the wall; 0 if
    /// there was no smoothing.
    pub moved_mm: f64,
    /// Recommended orientation.
    pub pose: PrintPose,
    /// Area in cm² that hangs over in that orientation; 0 if it prints without supports.
    pub overhang_cm2: f64,
}

/// Thickness below which a wall is notably thinner than requested, relative to the requested one.
pub(super) const THIN: f64 = 0.95;

/// Overhangs of at most this area print without supports, in cm².
const FREE_CM2: f64 = 0.2;

impl SolidFacts {
    /// Measures the body of a print.
    pub fn of(body: &Body, solid: Solid) -> Self {
        const CM3_PER_M3: f64 = 1e6;
        const CM2_PER_M2: f64 = 1e4;
        let asked_mm = if let Solid::Thickness { mm } = solid { mm } else { BACK_MM };
        let overhang = |pose: PrintPose| {
            let area_cm2 = body.overhang_m2(pose.up()) * CM2_PER_M2;
            (pose, if area_cm2 <= FREE_CM2 { 0.0 } else { area_cm2 })
        };
        // The first of equal ones: lying prints the face without visible steps.
        let [lying, upright] = PrintPose::ALL.map(overhang);
        let (pose, overhang_cm2) = if upright.1 < lying.1 { upright } else { lying };
        Self {
            volume_cm3: body.volume_m3() * CM3_PER_M3,
            size_mm: body.size_m() * MM_PER_M,
            pla_g: body.printed_mass_g(PLA_G_PER_CM3),
            asked_mm,
            thinnest_mm: body.thinnest_m() * MM_PER_M,
            thin_share: body.thinner_share(THIN * asked_mm / MM_PER_M),
            moved_mm: body.moved_m() * MM_PER_M,
            pose,
            overhang_cm2,
        }
    }
}
