use crate::areas::Area;
use crate::mirror_of;

rosto_mesh::named! {
    /// A named region of the face, for selecting, moving or fixing its landmarks together.
    ///
    /// Left and right are the subject's. Regions may overlap: the nose includes its tip, the lips both lips.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Region {
        /// From the hairline to above the brows.
        Forehead = "forehead",
        /// The temple next to the right eye.
        RightTemple = "right-temple",
        /// The temple next to the left eye.
        LeftTemple = "left-temple",
        /// The right brow.
        RightBrow = "right-brow",
        /// The left brow.
        LeftBrow = "left-brow",
        /// The right eye: both lids and corners.
        RightEye = "right-eye",
        /// The left eye: both lids and corners.
        LeftEye = "left-eye",
        /// The right upper lid, from its edge to its crease.
        RightUpperEyelid = "right-upper-eyelid",
        /// The left upper lid, from its edge to its crease.
        LeftUpperEyelid = "left-upper-eyelid",
        /// The right lower lid.
        RightLowerEyelid = "right-lower-eyelid",
        /// The left lower lid.
        LeftLowerEyelid = "left-lower-eyelid",
        /// The whole nose.
        Nose = "nose",
        /// The ridge from the root of the nose to above its tip.
        NoseBridge = "nose-bridge",
        /// The tip of the nose.
        NoseTip = "nose-tip",
        /// The right wing of the nose with its nostril.
        RightNoseWing = "right-nose-wing",
        /// The left wing of the nose with its nostril.
        LeftNoseWing = "left-nose-wing",
        /// The right cheekbone.
        RightCheekbone = "right-cheekbone",
        /// The left cheekbone.
        LeftCheekbone = "left-cheekbone",
        /// The right cheek below the cheekbone.
        RightCheek = "right-cheek",
        /// The left cheek below the cheekbone.
        LeftCheek = "left-cheek",
        /// Both lips and the corners of the mouth.
        Lips = "lips",
        /// The upper lip.
        UpperLip = "upper-lip",
        /// The lower lip.
        LowerLip = "lower-lip",
        /// The chin.
        Chin = "chin",
        /// The whole jaw: both sides and the chin.
        Jaw = "jaw",
        /// The right side of the jaw.
        RightJaw = "right-jaw",
        /// The left side of the jaw.
        LeftJaw = "left-jaw",
    }
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
    /// Landmarks of the region, ascending.
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

    /// Regions that contain a landmark, from the smallest to the largest.
    pub fn containing(landmark: u32) -> Vec<Self> {
        let sized = Self::ALL.into_iter().map(|region| (region.vertices(), region));
        let mut found: Vec<_> = sized.filter(|(vertices, _)| vertices.contains(&landmark)).collect();
        found.sort_by_key(|(vertices, _)| vertices.len());
        found.into_iter().map(|(_, region)| region).collect()
    }

    /// How far the region's place differs between adults, in mm: about two standard deviations of the distances that
    /// it determines, such as 2 × 3.5 mm for the length of the nose, and half of that for each side of a width.
    ///
    /// Source: L. G. Farkas (ed.), Anthropometry of the Head and Face, 2nd edition, Raven Press 1994, rounded.
    pub fn spread_mm(self) -> f64 {
        match self {
            Self::Forehead => 10.0,
            Self::Chin | Self::Jaw => 9.0,
            Self::Nose | Self::NoseTip => 7.0,
            Self::RightJaw | Self::LeftJaw | Self::RightCheek | Self::LeftCheek => 6.0,
            Self::RightTemple | Self::LeftTemple | Self::RightBrow | Self::LeftBrow => 5.0,
            Self::RightCheekbone | Self::LeftCheekbone | Self::NoseBridge | Self::Lips => 4.0,
            Self::RightEye | Self::LeftEye | Self::UpperLip | Self::LowerLip => 3.0,
            Self::RightNoseWing | Self::LeftNoseWing => 3.0,
            Self::RightUpperEyelid | Self::LeftUpperEyelid | Self::RightLowerEyelid | Self::LeftLowerEyelid => 2.0,
        }
    }

    /// The mirror image of the region.
    pub fn mirrored(self) -> Self {
        let (areas, side) = self.definition();
        let image = (areas, side.mirrored());
        Self::ALL.into_iter().find(|region| region.definition() == image).expect("invariant: sides come in pairs")
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
}
