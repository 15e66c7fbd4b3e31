use crate::areas::Area;
use crate::{Language, mirror_of};

/// A named part of the face, for moving, pinning or finding its landmarks together.
///
/// Left and right are the subject's. Regions may overlap: the nose holds its tip, the lips hold both lips.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Region {
    /// From the hairline to above the brows.
    Forehead,
    /// The temple beside the right eye.
    RightTemple,
    /// The temple beside the left eye.
    LeftTemple,
    /// The right brow.
    RightBrow,
    /// The left brow.
    LeftBrow,
    /// The right eye: both lids and corners.
    RightEye,
    /// The left eye: both lids and corners.
    LeftEye,
    /// The right upper lid, from its edge to its crease.
    RightUpperEyelid,
    /// The left upper lid, from its edge to its crease.
    LeftUpperEyelid,
    /// The right lower lid.
    RightLowerEyelid,
    /// The left lower lid.
    LeftLowerEyelid,
    /// The whole nose.
    Nose,
    /// The ridge from the root of the nose to above its tip.
    NoseBridge,
    /// The tip of the nose.
    NoseTip,
    /// The right wing of the nose with its nostril.
    RightNoseWing,
    /// The left wing of the nose with its nostril.
    LeftNoseWing,
    /// The right cheekbone.
    RightCheekbone,
    /// The left cheekbone.
    LeftCheekbone,
    /// The right cheek below its bone.
    RightCheek,
    /// The left cheek below its bone.
    LeftCheek,
    /// Both lips and the corners of the mouth.
    Lips,
    /// The upper lip.
    UpperLip,
    /// The lower lip.
    LowerLip,
    /// The chin.
    Chin,
    /// The whole jaw: both sides and the chin.
    Jaw,
    /// The right side of the jaw.
    RightJaw,
    /// The left side of the jaw.
    LeftJaw,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Right,
    Left,
    Both,
}

impl Side {
    fn mirrored(self) -> Self {
        match self {
            Self::Right => Self::Left,
            Self::Left => Self::Right,
            Self::Both => Self::Both,
        }
    }
}

impl Region {
    /// Every region, from the forehead down.
    pub const ALL: [Self; 27] = [
        Self::Forehead,
        Self::RightTemple,
        Self::LeftTemple,
        Self::RightBrow,
        Self::LeftBrow,
        Self::RightEye,
        Self::LeftEye,
        Self::RightUpperEyelid,
        Self::LeftUpperEyelid,
        Self::RightLowerEyelid,
        Self::LeftLowerEyelid,
        Self::Nose,
        Self::NoseBridge,
        Self::NoseTip,
        Self::RightNoseWing,
        Self::LeftNoseWing,
        Self::RightCheekbone,
        Self::LeftCheekbone,
        Self::RightCheek,
        Self::LeftCheek,
        Self::Lips,
        Self::UpperLip,
        Self::LowerLip,
        Self::Chin,
        Self::Jaw,
        Self::RightJaw,
        Self::LeftJaw,
    ];

    /// The region's landmarks, ascending.
    pub fn vertices(self) -> Vec<u32> {
        let (areas, side) = self.definition();
        let right = areas.iter().flat_map(|area| area.right_half()).map(|&landmark| u32::from(landmark));
        let mut vertices: Vec<u32> = match side {
            Side::Right => right.collect(),
            Side::Left => right.map(mirror_of).collect(),
            Side::Both => right.flat_map(|landmark| [landmark, mirror_of(landmark)]).collect(),
        };
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The regions that a landmark is part of, from the smallest to the largest.
    pub fn containing(landmark: u32) -> Vec<Self> {
        let sized = Self::ALL.into_iter().map(|region| (region.vertices(), region));
        let mut found: Vec<_> = sized.filter(|(vertices, _)| vertices.contains(&landmark)).collect();
        found.sort_by_key(|(vertices, _)| vertices.len());
        found.into_iter().map(|(_, region)| region).collect()
    }

    /// The region that this one becomes in the mirror.
    pub fn mirrored(self) -> Self {
        let (areas, side) = self.definition();
        let image = (areas, side.mirrored());
        Self::ALL.into_iter().find(|region| region.definition() == image).expect("invariant: sides come in pairs")
    }

    /// A stable name for files and command lines, such as `left-nose-wing`.
    pub fn id(self) -> &'static str {
        self.words().0
    }

    /// The region whose [`Self::id`] is `id`.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|region| region.id() == id)
    }

    /// The region's name for people.
    pub fn name(self, language: Language) -> &'static str {
        match language {
            Language::English => self.words().1,
            Language::Portuguese => self.words().2,
        }
    }

    fn definition(self) -> (&'static [Area], Side) {
        use Area::*;
        use Side::{Both, Left, Right};
        const EYE: &[Area] = &[UpperEyelid, EyeCorner, LowerEyelid];
        const WING: &[Area] = &[Area::NoseWing, Nostril];
        const JAW: &[Area] = &[Area::Jaw, SideOfFace];
        match self {
            Self::Forehead => (&[Area::Forehead, Glabella], Both),
            Self::RightTemple => (&[Temple], Right),
            Self::LeftTemple => (&[Temple], Left),
            Self::RightBrow => (&[Brow], Right),
            Self::LeftBrow => (&[Brow], Left),
            Self::RightEye => (EYE, Right),
            Self::LeftEye => (EYE, Left),
            Self::RightUpperEyelid => (&[UpperEyelid], Right),
            Self::LeftUpperEyelid => (&[UpperEyelid], Left),
            Self::RightLowerEyelid => (&[LowerEyelid], Right),
            Self::LeftLowerEyelid => (&[LowerEyelid], Left),
            Self::Nose => (&[Area::NoseBridge, NoseSide, Area::NoseTip, Area::NoseWing, Nostril], Both),
            Self::NoseBridge => (&[Area::NoseBridge], Both),
            Self::NoseTip => (&[Area::NoseTip], Both),
            Self::RightNoseWing => (WING, Right),
            Self::LeftNoseWing => (WING, Left),
            Self::RightCheekbone => (&[Cheekbone], Right),
            Self::LeftCheekbone => (&[Cheekbone], Left),
            Self::RightCheek => (&[Cheek, SmileLine], Right),
            Self::LeftCheek => (&[Cheek, SmileLine], Left),
            Self::Lips => (&[Area::UpperLip, MouthCorner, Area::LowerLip], Both),
            Self::UpperLip => (&[Area::UpperLip], Both),
            Self::LowerLip => (&[Area::LowerLip], Both),
            Self::Chin => (&[Area::Chin, ChinCrease], Both),
            Self::Jaw => (&[Area::Jaw, SideOfFace, Area::Chin, ChinCrease], Both),
            Self::RightJaw => (JAW, Right),
            Self::LeftJaw => (JAW, Left),
        }
    }

    /// Identifier, English name, Portuguese name.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Forehead => ("forehead", "forehead", "testa"),
            Self::RightTemple => ("right-temple", "right temple", "têmpora direita"),
            Self::LeftTemple => ("left-temple", "left temple", "têmpora esquerda"),
            Self::RightBrow => ("right-brow", "right brow", "sobrancelha direita"),
            Self::LeftBrow => ("left-brow", "left brow", "sobrancelha esquerda"),
            Self::RightEye => ("right-eye", "right eye", "olho direito"),
            Self::LeftEye => ("left-eye", "left eye", "olho esquerdo"),
            Self::RightUpperEyelid => ("right-upper-eyelid", "right upper eyelid", "pálpebra superior direita"),
            Self::LeftUpperEyelid => ("left-upper-eyelid", "left upper eyelid", "pálpebra superior esquerda"),
            Self::RightLowerEyelid => ("right-lower-eyelid", "right lower eyelid", "pálpebra inferior direita"),
            Self::LeftLowerEyelid => ("left-lower-eyelid", "left lower eyelid", "pálpebra inferior esquerda"),
            Self::Nose => ("nose", "nose", "nariz"),
            Self::NoseBridge => ("nose-bridge", "nose bridge", "dorso do nariz"),
            Self::NoseTip => ("nose-tip", "tip of the nose", "ponta do nariz"),
            Self::RightNoseWing => ("right-nose-wing", "right nose wing", "asa direita do nariz"),
            Self::LeftNoseWing => ("left-nose-wing", "left nose wing", "asa esquerda do nariz"),
            Self::RightCheekbone => ("right-cheekbone", "right cheekbone", "maçã direita do rosto"),
            Self::LeftCheekbone => ("left-cheekbone", "left cheekbone", "maçã esquerda do rosto"),
            Self::RightCheek => ("right-cheek", "right cheek", "bochecha direita"),
            Self::LeftCheek => ("left-cheek", "left cheek", "bochecha esquerda"),
            Self::Lips => ("lips", "lips", "lábios"),
            Self::UpperLip => ("upper-lip", "upper lip", "lábio superior"),
            Self::LowerLip => ("lower-lip", "lower lip", "lábio inferior"),
            Self::Chin => ("chin", "chin", "queixo"),
            Self::Jaw => ("jaw", "jaw", "mandíbula"),
            Self::RightJaw => ("right-jaw", "right side of the jaw", "lado direito da mandíbula"),
            Self::LeftJaw => ("left-jaw", "left side of the jaw", "lado esquerdo da mandíbula"),
        }
    }
}
