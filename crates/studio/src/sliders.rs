use glam::DVec3;
use rosto_face::{Language, Region};
use rosto_laplacian::ConstraintKind;

use crate::{AnchorKind, Anchors, Command, EditSpec, Mirror, Settings};

/// A ready-made change of a feature: a documented set of mirrored, exactly held handles, with pins around them.
///
/// All are symmetric, linear in their amount, and meant for a face in metres.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FaceSlider {
    /// The nose's wings move apart; its ridge, tip and base stay.
    NoseWidth,
    /// The tip, the base and the wings of the nose move down and a little forward; its root and the lips stay.
    NoseLength,
    /// The lids open and the eye's corners move apart; brows and cheekbones stay.
    EyeSize,
    /// Both eyes move outwards whole; the nose stays.
    EyeDistance,
    /// The lips' outer edges move up, down and forward; the corners and the line between the lips stay.
    LipFullness,
    /// The jaw's sides move apart; chin, mouth and everything above stay.
    JawWidth,
    /// The chin moves down; the lips, the jaw's angles and everything above stay.
    ChinLength,
    /// Both brows move up whole; eyes and hairline stay.
    BrowHeight,
    /// The cheekbones move outwards and forward; eyes, nose and mouth stay.
    Cheekbones,
    /// Chin and forehead move apart; eyes, nose and mouth stay.
    FaceLength,
}

/// Handles that are off the slider's way by less are on it.
const ROUNDING_M: f64 = 1e-12;

/// What a slider holds: landmarks of the midline and of the subject's right.
struct Definition {
    /// Landmark, and its displacement for a slider at 1.
    handles: Vec<(u32, DVec3)>,
    pins: &'static [u32],
    /// Whether the face's oval stays, too.
    oval: AnchorKind,
}

impl FaceSlider {
    /// Every slider.
    pub const ALL: [Self; 10] = [
        Self::NoseWidth,
        Self::NoseLength,
        Self::EyeSize,
        Self::EyeDistance,
        Self::LipFullness,
        Self::JawWidth,
        Self::ChinLength,
        Self::BrowHeight,
        Self::Cheekbones,
        Self::FaceLength,
    ];

    /// How far the slider goes to either side, in metres of its handles' way; beyond, faces look wrong.
    pub fn range_m(self) -> f64 {
        match self {
            Self::EyeSize => 0.002,
            Self::LipFullness => 0.003,
            Self::NoseWidth | Self::EyeDistance | Self::BrowHeight => 0.005,
            Self::NoseLength | Self::Cheekbones => 0.008,
            Self::JawWidth | Self::ChinLength | Self::FaceLength => 0.012,
        }
    }

    /// A stable name for files and command lines, such as `nose-width`.
    pub fn id(self) -> &'static str {
        self.words().0
    }

    /// The slider whose [`Self::id`] is `id`.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|slider| slider.id() == id)
    }

    /// The slider's name for people.
    pub fn name(self, language: Language) -> &'static str {
        match language {
            Language::English => self.words().1,
            Language::Portuguese => self.words().2,
        }
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
        EditSpec { level: 0, handles: definition.handles.into_iter().map(|(landmark, _)| landmark).collect(), settings }
    }

    /// The offsets in metres of [`Self::spec`]'s handles for the slider at `amount_m`.
    pub fn offsets_m(self, amount_m: f64) -> Vec<DVec3> {
        self.definition().handles.into_iter().map(|(_, way)| way * amount_m).collect()
    }

    /// The two axes of the model that every vertex's way is in the plane of.
    pub fn axes(self) -> [DVec3; 2] {
        match self {
            Self::NoseWidth | Self::EyeDistance | Self::JawWidth | Self::EyeSize => [DVec3::X, DVec3::Y],
            Self::Cheekbones => [DVec3::X, DVec3::Z],
            Self::NoseLength | Self::LipFullness | Self::ChinLength | Self::BrowHeight | Self::FaceLength => {
                [DVec3::Y, DVec3::Z]
            }
        }
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

    fn definition(self) -> Definition {
        let handles = |list: &[(u32, [f64; 3])]| list.iter().map(|&(v, way)| (v, DVec3::from(way))).collect();
        let whole = |region: Region, way: DVec3| region.vertices().into_iter().map(|v| (v, way)).collect();
        let (inside, outline) = (AnchorKind::Oval, AnchorKind::PinsOnly);
        let (handles, pins, oval): (_, &[u32], _) = match self {
            Self::NoseWidth => {
                let apart = [-1.0, 0.0, 0.0];
                (
                    handles(&[(64, apart), (129, apart), (98, apart), (49, [-0.7, 0.0, 0.0])]),
                    &[4, 2, 168, 0, 133],
                    inside,
                )
            }
            Self::NoseLength => {
                let (tip, base) = ([0.0, -1.0, 0.3], [0.0, -0.9, 0.0]);
                (handles(&[(4, tip), (1, tip), (2, base), (64, base), (129, base)]), &[168, 133, 61, 13], inside)
            }
            Self::EyeSize => {
                let (up, down) = ([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]);
                let corners = [(33, [-0.5, 0.0, 0.0]), (133, [0.5, 0.0, 0.0])];
                let part = |way: [f64; 3]| way.map(|w| 0.6 * w);
                let upper = [(161, part(up)), (160, up), (159, up), (158, up), (157, part(up))];
                let lower = [(163, part(down)), (144, down), (145, down), (153, down), (154, part(down))];
                (handles(&[&corners[..], &upper, &lower].concat()), &[168, 105, 50, 129], inside)
            }
            Self::EyeDistance => (whole(Region::RightEye, DVec3::NEG_X), &[168, 4, 105, 50], inside),
            Self::LipFullness => {
                let (upper, lower) = ([0.0, 1.0, 0.7], [0.0, -1.0, 0.7]);
                let edges = [(0, upper), (37, upper), (39, upper), (17, lower), (84, lower), (181, lower)];
                (handles(&edges), &[61, 78, 13, 82, 14, 87, 2, 200, 199, 208], inside)
            }
            Self::JawWidth => {
                let apart = [-1.0, 0.0, 0.0];
                let sides = [(58, apart), (172, apart), (136, apart), (150, [-0.8, 0.0, 0.0]), (132, [-0.6, 0.0, 0.0])];
                (handles(&sides), &[152, 61, 4, 33, 127, 10, 17], outline)
            }
            Self::ChinLength => {
                let down = [0.0, -1.0, 0.0];
                (
                    handles(&[(152, down), (148, down), (175, down), (199, [0.0, -0.8, 0.0])]),
                    &[61, 17, 58, 127, 10, 4],
                    outline,
                )
            }
            Self::BrowHeight => (whole(Region::RightBrow, DVec3::Y), &[33, 133, 159, 168, 4], inside),
            Self::Cheekbones => {
                let out = [-0.7, 0.0, 0.7];
                (handles(&[(117, out), (123, out), (50, out), (116, out)]), &[33, 133, 145, 129, 61], inside)
            }
            Self::FaceLength => {
                let (down, up) = ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
                let ends =
                    [(152, down), (148, down), (176, [0.0, -0.9, 0.0]), (10, up), (109, up), (67, [0.0, 0.9, 0.0])];
                (handles(&ends), &[61, 4, 33, 133, 234, 168], outline)
            }
        };
        Definition { handles, pins, oval }
    }

    /// Identifier, English name, Portuguese name.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::NoseWidth => ("nose-width", "Nose width", "Largura do nariz"),
            Self::NoseLength => ("nose-length", "Nose length", "Comprimento do nariz"),
            Self::EyeSize => ("eye-size", "Eye size", "Tamanho dos olhos"),
            Self::EyeDistance => ("eye-distance", "Eye distance", "Distância entre os olhos"),
            Self::LipFullness => ("lip-fullness", "Lip fullness", "Volume dos lábios"),
            Self::JawWidth => ("jaw-width", "Jaw width", "Largura da mandíbula"),
            Self::ChinLength => ("chin-length", "Chin length", "Comprimento do queixo"),
            Self::BrowHeight => ("brow-height", "Brow height", "Altura das sobrancelhas"),
            Self::Cheekbones => ("cheekbones", "Cheekbones", "Maçãs do rosto"),
            Self::FaceLength => ("face-length", "Face length", "Comprimento do rosto"),
        }
    }
}
