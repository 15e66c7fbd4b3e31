use std::collections::BTreeMap;

use glam::DVec3;
use rosto_face::{Area, mirror_of};

use super::lids;
use super::table::{Definition, Extent, Way};
use super::{Expression, table};
use crate::mirror::reflected;

/// The tangent of half the angle that the jaw opens by at 1: some 14°.
const HALF_TURN: f64 = 0.12;
/// How far the jaw's hinge slides down and forward as it opens, in mm of the canonical face.
const SLIDE_MM: DVec3 = DVec3::new(0.0, -5.0, 9.0);
/// Before the ears: the hinge lies between the two.
const TEMPLES: [usize; 2] = [234, 454];

/// What an expression says of a face before it is solved.
pub(super) struct Authored {
    /// Landmarks that are moved or stay.
    pub known: Vec<u32>,
    /// One way for each of them, in metres.
    pub displacements_m: Vec<DVec3>,
}

/// A face as a table sees it: the subject's right is its right, even where the table is that of the left.
struct Seen<'a> {
    rest_m: &'a [DVec3],
    is_mirrored: bool,
    /// Metres of this face for a millimetre of the canonical one.
    unit_m: f64,
}

impl Authored {
    /// Tables are those of the right; the left is seen in the mirror.
    pub(super) fn of(expression: Expression, rest_m: &[DVec3], canonical_m: &[DVec3]) -> Self {
        let (definition, is_mirrored) = table::definition(expression);
        let unit_m = 1e-3 * definition.sized_by.of(rest_m) / definition.sized_by.of(canonical_m);
        let face = Seen { rest_m, is_mirrored, unit_m };
        let mut ways = face.resting(&definition);
        face.move_handles(&definition, &mut ways);
        let back = |landmark: u32| if is_mirrored { mirror_of(landmark) } else { landmark };
        let way_back = |way: DVec3| if is_mirrored { reflected(way) } else { way };
        let known = ways.keys().map(|&landmark| back(landmark)).collect();
        Self { known, displacements_m: ways.into_values().map(way_back).collect() }
    }
}

impl Seen<'_> {
    /// Whatever is not to follow, and the pins.
    fn resting(&self, definition: &Definition) -> BTreeMap<u32, DVec3> {
        let follows = |landmark: u32| {
            let right = landmark.min(mirror_of(landmark));
            let is_on_side = definition.extent != Extent::Half || right == landmark;
            let holds = |area: &Area| area.right_half().iter().any(|&member| u32::from(member) == right);
            is_on_side && definition.follow.iter().any(holds)
        };
        let pinned = definition.pins.iter().flat_map(|&pin| [pin, mirror_of(pin)]);
        let rest = (0..self.rest_m.len() as u32).filter(|&landmark| !follows(landmark));
        rest.chain(pinned).map(|landmark| (landmark, DVec3::ZERO)).collect()
    }

    fn move_handles(&self, definition: &Definition, ways: &mut BTreeMap<u32, DVec3>) {
        for (landmarks, way) in definition.handles {
            for &landmark in *landmarks {
                let way_m = self.way_m(landmark, *way);
                let partner = mirror_of(landmark);
                ways.insert(landmark, way_m);
                match definition.extent {
                    _ if partner == landmark => {}
                    Extent::Half => {}
                    Extent::Both => _ = ways.insert(partner, reflected(self.seen_in_mirror().way_m(landmark, *way))),
                    Extent::Sideways => {
                        let way_m = reflected(self.seen_in_mirror().way_m(landmark, *way));
                        ways.insert(partner, DVec3::new(-way_m.x, way_m.y, way_m.z));
                    }
                }
            }
        }
    }

    fn way_m(&self, landmark: u32, way: Way) -> DVec3 {
        match way {
            Way::By(way_mm) => DVec3::from(way_mm) * self.unit_m,
            Way::Lid(share) => lids::way_m(|lid| self.at(lid), landmark, self.unit_m) * share,
            Way::Jaw(share, way_mm) => self.jaw_m(landmark) * share + DVec3::from(way_mm) * self.unit_m,
            Way::Seal(below, share) => self.jaw_m(below) * share,
        }
    }

    /// A landmark's way as the jaw opens: it turns about its hinge, which slides down and forward.
    fn jaw_m(&self, landmark: u32) -> DVec3 {
        let hinge = (self.rest_m[TEMPLES[0]] + self.rest_m[TEMPLES[1]]) / 2.0;
        let arm = self.at(landmark) - DVec3::new(0.0, hinge.y, hinge.z);
        let whole = 1.0 + HALF_TURN * HALF_TURN;
        let (less, sine) = (2.0 * HALF_TURN * HALF_TURN / whole, 2.0 * HALF_TURN / whole);
        DVec3::new(0.0, -less * arm.y - sine * arm.z, sine * arm.y - less * arm.z) + SLIDE_MM * self.unit_m
    }

    /// Where a landmark of the table is.
    fn at(&self, landmark: u32) -> DVec3 {
        match self.is_mirrored {
            true => reflected(self.rest_m[mirror_of(landmark) as usize]),
            false => self.rest_m[landmark as usize],
        }
    }

    fn seen_in_mirror(&self) -> Self {
        Self { is_mirrored: !self.is_mirrored, ..*self }
    }
}
