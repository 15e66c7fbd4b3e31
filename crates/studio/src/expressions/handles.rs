use std::collections::BTreeMap;

use glam::DVec3;
use rosto_face::{Area, mirror_of};

use super::lids;
use super::table::{Definition, Extent, Motion};
use super::{Expression, table};
use crate::mirror::reflected;

/// Tangent of half the jaw's opening angle at weight 1 (about 14°).
const HALF_TURN: f64 = 0.12;
/// Slide of the jaw's hinge down and forward as it opens, in mm of the canonical face.
const SLIDE_MM: DVec3 = DVec3::new(0.0, -5.0, 9.0);
/// Landmarks in front of the ears; the hinge lies midway between them.
const TEMPLES: [usize; 2] = [234, 454];

/// Prescribed displacements of an expression: the boundary conditions of its solve.
pub(super) struct Prescribed {
    /// Landmarks that are moved or fixed.
    pub landmarks: Vec<u32>,
    /// Displacement of each of them, in metres.
    pub displacements_m: Vec<DVec3>,
}

/// A face as seen by a table of the right side; reflected for an expression of the left.
struct TableFace<'a> {
    rest_m: &'a [DVec3],
    is_mirrored: bool,
    /// Metres on this face per millimetre of the canonical face.
    unit_m: f64,
}

impl Prescribed {
    /// Tables describe the right side; expressions of the left use the reflected face.
    pub(super) fn of(expression: Expression, rest_m: &[DVec3], canonical_m: &[DVec3]) -> Self {
        let (definition, is_mirrored) = table::definition(expression);
        let unit_m = 1e-3 * definition.sized_by.of(rest_m) / definition.sized_by.of(canonical_m);
        let face = TableFace { rest_m, is_mirrored, unit_m };
        let mut displacements_m = face.fixed(&definition);
        face.move_handles(&definition, &mut displacements_m);
        let back = |landmark: u32| if is_mirrored { mirror_of(landmark) } else { landmark };
        let reflected_back = |vector: DVec3| if is_mirrored { reflected(vector) } else { vector };
        let landmarks = displacements_m.keys().map(|&landmark| back(landmark)).collect();
        Self { landmarks, displacements_m: displacements_m.into_values().map(reflected_back).collect() }
    }
}

impl TableFace<'_> {
    /// Zero displacement for the pins and for landmarks that do not follow the handles.
    fn fixed(&self, definition: &Definition) -> BTreeMap<u32, DVec3> {
        let follows = |landmark: u32| {
            let right = landmark.min(mirror_of(landmark));
            let is_on_side = definition.extent != Extent::Half || right == landmark;
            let contains = |area: &Area| area.right_half().iter().any(|&member| u32::from(member) == right);
            is_on_side && definition.follow.iter().any(contains)
        };
        let pinned = definition.pins.iter().flat_map(|&pin| [pin, mirror_of(pin)]);
        let rest = (0..self.rest_m.len() as u32).filter(|&landmark| !follows(landmark));
        rest.chain(pinned).map(|landmark| (landmark, DVec3::ZERO)).collect()
    }

    fn move_handles(&self, definition: &Definition, displacements_m: &mut BTreeMap<u32, DVec3>) {
        for (landmarks, motion) in definition.handles {
            for &landmark in *landmarks {
                let displacement_m = self.displacement_m(landmark, *motion);
                let partner = mirror_of(landmark);
                displacements_m.insert(landmark, displacement_m);
                match definition.extent {
                    _ if partner == landmark => {}
                    Extent::Half => {}
                    Extent::Both => {
                        _ = displacements_m
                            .insert(partner, reflected(self.mirrored().displacement_m(landmark, *motion)))
                    }
                    Extent::Sideways => {
                        let displacement_m = reflected(self.mirrored().displacement_m(landmark, *motion));
                        displacements_m
                            .insert(partner, DVec3::new(-displacement_m.x, displacement_m.y, displacement_m.z));
                    }
                }
            }
        }
    }

    fn displacement_m(&self, landmark: u32, motion: Motion) -> DVec3 {
        match motion {
            Motion::By(offset_mm) => DVec3::from(offset_mm) * self.unit_m,
            Motion::Lid(share) => lids::displacement_m(|lid| self.at(lid), landmark, self.unit_m) * share,
            Motion::Jaw(share, offset_mm) => self.jaw_m(landmark) * share + DVec3::from(offset_mm) * self.unit_m,
            Motion::Seal(below, share) => self.jaw_m(below) * share,
        }
    }

    /// Displacement of a landmark as the jaw opens: a rotation about the hinge, which slides down and forward.
    fn jaw_m(&self, landmark: u32) -> DVec3 {
        let hinge = (self.rest_m[TEMPLES[0]] + self.rest_m[TEMPLES[1]]) / 2.0;
        let arm = self.at(landmark) - DVec3::new(0.0, hinge.y, hinge.z);
        let denominator = 1.0 + HALF_TURN * HALF_TURN;
        let (one_minus_cosine, sine) = (2.0 * HALF_TURN * HALF_TURN / denominator, 2.0 * HALF_TURN / denominator);
        DVec3::new(0.0, -one_minus_cosine * arm.y - sine * arm.z, sine * arm.y - one_minus_cosine * arm.z)
            + SLIDE_MM * self.unit_m
    }

    /// Position of a landmark of the table.
    fn at(&self, landmark: u32) -> DVec3 {
        match self.is_mirrored {
            true => reflected(self.rest_m[mirror_of(landmark) as usize]),
            false => self.rest_m[landmark as usize],
        }
    }

    fn mirrored(&self) -> Self {
        Self { is_mirrored: !self.is_mirrored, ..*self }
    }
}
