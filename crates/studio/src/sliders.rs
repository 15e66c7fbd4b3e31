use glam::DVec3;
use rosto_face::Region;
use rosto_laplacian::ConstraintKind;

use crate::{AnchorKind, Anchors, Command, EditSpec, Mirror, Settings};

rosto_mesh::named! {
    /// A ready-made edit of a proportion: mirrored, hard-constrained handles with pins around them.
    ///
    /// Each is symmetric, linear in its amount, and intended for a face in metres.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum FaceSlider {
        /// The wings of the nose move apart; ridge, tip and base stay.
        NoseWidth = "nose-width",
        /// The tip, the base and the wings of the nose move down and a little forward; its root and the lips stay.
        NoseLength = "nose-length",
        /// The lids open and the corners of the eye move apart; brows and cheekbones stay.
        EyeSize = "eye-size",
        /// Both eyes move outwards as a whole; the nose stays.
        EyeDistance = "eye-distance",
        /// The outer edges of the lips move up, down and forward; the corners and the line between the lips stay.
        LipFullness = "lip-fullness",
        /// The sides of the jaw move apart; chin, mouth and the face above stay.
        JawWidth = "jaw-width",
        /// The chin moves down; the lips, the angles of the jaw and the face above stay.
        ChinLength = "chin-length",
        /// Both brows move up as a whole; eyes and hairline stay.
        BrowHeight = "brow-height",
        /// The cheekbones move outwards and forward; eyes, nose and mouth stay.
        Cheekbones = "cheekbones",
        /// Chin and forehead move apart; eyes, nose and mouth stay.
        FaceLength = "face-length",
    }
}

/// Tolerance for recognising the slider's direction in a handle's offset.
const ROUNDING_M: f64 = 1e-12;

/// Definition of a slider. Handles and pins are landmarks of the midline and of the subject's right.
struct Definition {
    /// Range to either side, in metres of handle displacement.
    range_m: f64,
    handles: Handles,
    /// Plane that contains all displacements.
    plane: Plane,
    pins: &'static [u32],
    /// Whether the face's oval is anchored too.
    oval: AnchorKind,
}

/// The handles of a slider and their offsets at amount 1.
enum Handles {
    Each(&'static [(u32, [f64; 3])]),
    All(Region, [f64; 3]),
}

/// Plane spanned by two axes of the model.
enum Plane {
    XY,
    XZ,
    YZ,
}

impl FaceSlider {
    /// Range to either side, in metres of handle displacement; faces look wrong beyond it.
    pub fn range_m(self) -> f64 {
        self.definition().range_m
    }

    /// The spec to prepare.
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

    /// Offsets in metres of [`Self::spec`]'s handles at `amount_m`.
    pub fn offsets_m(self, amount_m: f64) -> Vec<DVec3> {
        self.handles().into_iter().map(|(_, direction)| direction * amount_m).collect()
    }

    /// The two axes of the model that span the plane of all displacements.
    pub fn axes(self) -> [DVec3; 2] {
        self.definition().plane.axes()
    }

    /// The command that moves the slider by `amount_m`.
    pub fn command(self, amount_m: f64) -> Command {
        Command::Move { spec: self.spec(), offsets: self.offsets_m(amount_m) }
    }

    /// Amount, in metres, by which a command moves this slider; `None` if it is a different command.
    ///
    /// Sliders are linear and independent of earlier edits, so the amounts of several such commands add up to the
    /// slider's value.
    pub fn amount_m(self, command: &Command) -> Option<f64> {
        let Command::Move { spec, offsets } = command else { return None };
        let directions = self.offsets_m(1.0);
        if offsets.len() != directions.len() || *spec != self.spec() {
            return None;
        }
        let along = |offsets: &[DVec3]| {
            offsets.iter().zip(&directions).map(|(offset, direction)| offset.dot(*direction)).sum::<f64>()
        };
        let amount_m = along(offsets) / along(&directions);
        let is_along = |(offset, direction): (&DVec3, &DVec3)| offset.distance(*direction * amount_m) < ROUNDING_M;
        offsets.iter().zip(&directions).all(is_along).then_some(amount_m)
    }

    fn handles(self) -> Vec<(u32, DVec3)> {
        match self.definition().handles {
            Handles::Each(list) => {
                list.iter().map(|&(landmark, direction)| (landmark, DVec3::from(direction))).collect()
            }
            Handles::All(region, direction) => {
                region.vertices().into_iter().map(|v| (v, DVec3::from(direction))).collect()
            }
        }
    }

    /// The table of sliders; each arm contains the full definition.
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
                range_m: 0.004, plane: XZ, oval: inside, pins: &[33, 133, 145, 129, 61],
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
