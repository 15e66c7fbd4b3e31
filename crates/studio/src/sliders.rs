use glam::DVec3;
use rosto_face::Region;
use rosto_laplacian::ConstraintKind;

use crate::{AnchorKind, Anchors, Command, EditSpec, Mirror, Settings};

rosto_mesh::named! {
    /// A ready-made change of a feature: a documented set of mirrored, exactly held handles, with pins around them.
    ///
    /// All are symmetric, linear in their amount, and meant for a face in metres.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum FaceSlider {
        /// The nose's wings move apart; its ridge, tip and base stay.
        NoseWidth = "nose-width",
        /// The tip, the base and the wings of the nose move down and a little forward; its root and the lips stay.
        NoseLength = "nose-length",
        /// The lids open and the eye's corners move apart; brows and cheekbones stay.
        EyeSize = "eye-size",
        /// Both eyes move outwards whole; the nose stays.
        EyeDistance = "eye-distance",
        /// The lips' outer edges move up, down and forward; the corners and the line between the lips stay.
        LipFullness = "lip-fullness",
        /// The jaw's sides move apart; chin, mouth and everything above stay.
        JawWidth = "jaw-width",
        /// The chin moves down; the lips, the jaw's angles and everything above stay.
        ChinLength = "chin-length",
        /// Both brows move up whole; eyes and hairline stay.
        BrowHeight = "brow-height",
        /// The cheekbones move outwards and forward; eyes, nose and mouth stay.
        Cheekbones = "cheekbones",
        /// Chin and forehead move apart; eyes, nose and mouth stay.
        FaceLength = "face-length",
    }
}

/// Handles that are off the slider's way by less are on it.
const ROUNDING_M: f64 = 1e-12;

/// A slider in full. Handles and pins are landmarks of the midline and of the subject's right.
struct Definition {
    /// How far it goes to either side, in metres of its handles' way.
    range_m: f64,
    handles: Handles,
    /// The plane that every vertex's way is in.
    plane: Plane,
    pins: &'static [u32],
    /// Whether the face's oval stays, too.
    oval: AnchorKind,
}

/// What a slider moves, and by which displacement at 1.
enum Handles {
    Each(&'static [(u32, [f64; 3])]),
    All(Region, [f64; 3]),
}

/// A plane of the model, spanned by two of its axes.
enum Plane {
    XY,
    XZ,
    YZ,
}

impl FaceSlider {
    /// How far the slider goes to either side, in metres of its handles' way; beyond, faces look wrong.
    pub fn range_m(self) -> f64 {
        self.definition().range_m
    }

    /// What to take hold of.
    pub fn spec(self) -> EditSpec {
        let definition = self.definition();
        let settings = Settings {
            constraint: ConstraintKind::Hard,
            anchors: Anchors { kind: definition.oval, pins: definition.pins.to_vec() },
            mirror: Mirror::On,
            ..Settings::default()
        };
        EditSpec { level: 0, handles: self.handles().into_iter().map(|(landmark, _)| landmark).collect(), settings }
    }

    /// The offsets in metres of [`Self::spec`]'s handles for the slider at `amount_m`.
    pub fn offsets_m(self, amount_m: f64) -> Vec<DVec3> {
        self.handles().into_iter().map(|(_, way)| way * amount_m).collect()
    }

    /// The two axes of the model that every vertex's way is in the plane of.
    pub fn axes(self) -> [DVec3; 2] {
        self.definition().plane.axes()
    }

    /// The whole change.
    pub fn command(self, amount_m: f64) -> Command {
        Command::Move { spec: self.spec(), offsets: self.offsets_m(amount_m) }
    }

    /// How far a command moves this slider, in metres; `None` for one that does something else.
    ///
    /// Sliders are linear and do not depend on what was done before, so that the amounts of several such commands add up
    /// to where the slider stands.
    pub fn amount_m(self, command: &Command) -> Option<f64> {
        let Command::Move { spec, offsets } = command else { return None };
        let ways = self.offsets_m(1.0);
        if offsets.len() != ways.len() || *spec != self.spec() {
            return None;
        }
        let along = |offsets: &[DVec3]| offsets.iter().zip(&ways).map(|(offset, way)| offset.dot(*way)).sum::<f64>();
        let amount_m = along(offsets) / along(&ways);
        let is_along = |(offset, way): (&DVec3, &DVec3)| offset.distance(*way * amount_m) < ROUNDING_M;
        offsets.iter().zip(&ways).all(is_along).then_some(amount_m)
    }

    fn handles(self) -> Vec<(u32, DVec3)> {
        match self.definition().handles {
            Handles::Each(list) => list.iter().map(|&(landmark, way)| (landmark, DVec3::from(way))).collect(),
            Handles::All(region, way) => region.vertices().into_iter().map(|v| (v, DVec3::from(way))).collect(),
        }
    }

    /// The table of sliders: all that one is made of stands in its arm.
    #[rustfmt::skip]
    fn definition(self) -> Definition {
        use Handles::{All, Each};
        use Plane::{XY, XZ, YZ};
        let (inside, outline) = (AnchorKind::Oval, AnchorKind::PinsOnly);
        match self {
            Self::NoseWidth => Definition {
                range_m: 0.005, plane: XY, oval: inside, pins: &[4, 2, 168, 0, 133],
                handles: Each(&[(64, [-1.0, 0.0, 0.0]), (129, [-1.0, 0.0, 0.0]), (98, [-1.0, 0.0, 0.0]), (49, [-0.7, 0.0, 0.0])]),
            },
            Self::NoseLength => Definition {
                range_m: 0.008, plane: YZ, oval: inside, pins: &[168, 133, 61, 13],
                handles: Each(&[
                    (4, [0.0, -1.0, 0.3]), (1, [0.0, -1.0, 0.3]),
                    (2, [0.0, -0.9, 0.0]), (64, [0.0, -0.9, 0.0]), (129, [0.0, -0.9, 0.0]),
                ]),
            },
            Self::EyeSize => Definition {
                range_m: 0.002, plane: XY, oval: inside, pins: &[168, 105, 50, 129],
                handles: Each(&[
                    (33, [-0.5, 0.0, 0.0]), (133, [0.5, 0.0, 0.0]),
                    (161, [0.0, 0.6, 0.0]), (160, [0.0, 1.0, 0.0]), (159, [0.0, 1.0, 0.0]), (158, [0.0, 1.0, 0.0]),
                    (157, [0.0, 0.6, 0.0]),
                    (163, [0.0, -0.6, 0.0]), (144, [0.0, -1.0, 0.0]), (145, [0.0, -1.0, 0.0]), (153, [0.0, -1.0, 0.0]),
                    (154, [0.0, -0.6, 0.0]),
                ]),
            },
            Self::EyeDistance => Definition {
                range_m: 0.005, plane: XY, oval: inside, pins: &[168, 4, 105, 50],
                handles: All(Region::RightEye, [-1.0, 0.0, 0.0]),
            },
            Self::LipFullness => Definition {
                range_m: 0.003, plane: YZ, oval: inside, pins: &[61, 78, 13, 82, 14, 87, 2, 200, 199, 208],
                handles: Each(&[
                    (0, [0.0, 1.0, 0.7]), (37, [0.0, 1.0, 0.7]), (39, [0.0, 1.0, 0.7]),
                    (17, [0.0, -1.0, 0.7]), (84, [0.0, -1.0, 0.7]), (181, [0.0, -1.0, 0.7]),
                ]),
            },
            Self::JawWidth => Definition {
                range_m: 0.012, plane: XY, oval: outline, pins: &[152, 61, 4, 33, 127, 10, 17],
                handles: Each(&[
                    (58, [-1.0, 0.0, 0.0]), (172, [-1.0, 0.0, 0.0]), (136, [-1.0, 0.0, 0.0]),
                    (150, [-0.8, 0.0, 0.0]), (132, [-0.6, 0.0, 0.0]),
                ]),
            },
            Self::ChinLength => Definition {
                range_m: 0.012, plane: YZ, oval: outline, pins: &[61, 17, 58, 127, 10, 4],
                handles: Each(&[
                    (152, [0.0, -1.0, 0.0]), (148, [0.0, -1.0, 0.0]), (175, [0.0, -1.0, 0.0]), (199, [0.0, -0.8, 0.0]),
                ]),
            },
            Self::BrowHeight => Definition {
                range_m: 0.005, plane: YZ, oval: inside, pins: &[33, 133, 159, 168, 4],
                handles: All(Region::RightBrow, [0.0, 1.0, 0.0]),
            },
            Self::Cheekbones => Definition {
                range_m: 0.008, plane: XZ, oval: inside, pins: &[33, 133, 145, 129, 61],
                handles: Each(&[
                    (117, [-0.7, 0.0, 0.7]), (123, [-0.7, 0.0, 0.7]), (50, [-0.7, 0.0, 0.7]), (116, [-0.7, 0.0, 0.7]),
                ]),
            },
            Self::FaceLength => Definition {
                range_m: 0.012, plane: YZ, oval: outline, pins: &[61, 4, 33, 133, 234, 168],
                handles: Each(&[
                    (152, [0.0, -1.0, 0.0]), (148, [0.0, -1.0, 0.0]), (176, [0.0, -0.9, 0.0]),
                    (10, [0.0, 1.0, 0.0]), (109, [0.0, 1.0, 0.0]), (67, [0.0, 0.9, 0.0]),
                ]),
            },
        }
    }
}

impl Plane {
    fn axes(&self) -> [DVec3; 2] {
        match self {
            Self::XY => [DVec3::X, DVec3::Y],
            Self::XZ => [DVec3::X, DVec3::Z],
            Self::YZ => [DVec3::Y, DVec3::Z],
        }
    }
}
