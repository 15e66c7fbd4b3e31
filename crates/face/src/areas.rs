use crate::mirror_of;

rosto_mesh::named! {
    /// Disjoint parts of the face that cover all landmarks.
    ///
    /// A part is defined by its landmarks on the midline and on the subject's right; the left half is their mirror
    /// image.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Area {
        /// From the hairline to above the brows.
        Forehead = "forehead",
        /// Between the brows.
        Glabella = "glabella",
        /// Lateral to the eye and the brow.
        Temple = "temple",
        /// The brow.
        Brow = "brow",
        /// The upper lid, from its edge to its crease.
        UpperEyelid = "upper-eyelid",
        /// The corners of the eye.
        EyeCorner = "eye-corner",
        /// The lower lid.
        LowerEyelid = "lower-eyelid",
        /// From the lid's crease to the brow.
        UnderBrow = "under-brow",
        /// Below the lower lid.
        UnderEye = "under-eye",
        /// The cheekbone.
        Cheekbone = "cheekbone",
        /// The cheek below the cheekbone.
        Cheek = "cheek",
        /// In front of the ear.
        SideOfFace = "side-of-face",
        /// The ridge from the root of the nose to above its tip.
        NoseBridge = "nose-bridge",
        /// The flank of the nose, next to the bridge.
        NoseSide = "nose-side",
        /// The tip of the nose.
        NoseTip = "nose-tip",
        /// The wing of the nose.
        NoseWing = "nose-wing",
        /// The nostril and the base of the nose.
        Nostril = "nostril",
        /// Between nose and upper lip.
        Philtrum = "philtrum",
        /// The upper lip.
        UpperLip = "upper-lip",
        /// The corner of the mouth.
        MouthCorner = "mouth-corner",
        /// The lower lip.
        LowerLip = "lower-lip",
        /// Between lower lip and chin.
        ChinCrease = "chin-crease",
        /// From the wing of the nose down past the corner of the mouth.
        SmileLine = "smile-line",
        /// The chin.
        Chin = "chin",
        /// The side of the jaw.
        Jaw = "jaw",
    }
}

impl Area {
    /// Landmarks on the midline and on the subject's right.
    pub fn right_half(self) -> &'static [u16] {
        match self {
            Self::Forehead => &[10, 151, 109, 108, 67, 69, 103, 104, 54, 68],
            Self::Glabella => &[9, 8],
            Self::Temple => &[21, 71, 162, 139, 127, 34, 156, 143],
            Self::Brow => &[46, 53, 52, 65, 55, 70, 63, 105, 66, 107],
            Self::UpperEyelid => &[246, 161, 160, 159, 158, 157, 173, 247, 30, 29, 27, 28, 56, 190],
            Self::EyeCorner => &[33, 133, 130, 243],
            Self::LowerEyelid => &[7, 163, 144, 145, 153, 154, 155, 25, 110, 24, 23, 22, 26, 112],
            Self::UnderBrow => &[124, 113, 225, 224, 223, 222, 221, 189],
            Self::UnderEye => &[35, 226, 31, 228, 229, 230, 231, 232, 233, 244],
            Self::Cheekbone => &[111, 116, 117, 118, 119, 123, 50, 227],
            Self::Cheek => &[187, 207, 205, 101, 36, 142, 100, 120, 121, 147],
            Self::SideOfFace => &[234, 93, 132, 137, 177],
            Self::NoseBridge => &[168, 6, 197, 195, 193, 122, 196, 3, 245, 188, 174],
            Self::NoseSide => &[128, 114, 47, 217, 236, 134, 198, 126, 209],
            Self::NoseTip => &[5, 4, 1, 19, 51, 45, 44, 125],
            Self::NoseWing => &[131, 49, 48, 64, 102, 129, 115, 219, 235, 220, 218],
            Self::Nostril => &[94, 2, 237, 239, 79, 238, 241, 20, 242, 141, 60, 75, 59, 166, 240, 99, 98, 97],
            Self::Philtrum => &[164, 167, 165, 92],
            Self::UpperLip => &[0, 11, 12, 13, 37, 39, 40, 185, 72, 73, 74, 184, 38, 41, 42, 183, 82, 81, 80, 191],
            Self::MouthCorner => &[61, 76, 62, 78],
            Self::LowerLip => &[17, 16, 15, 14, 84, 181, 91, 146, 85, 180, 90, 77, 86, 179, 89, 96, 87, 178, 88, 95],
            Self::ChinCrease => &[18, 83, 182, 106, 204],
            Self::SmileLine => &[203, 206, 216, 186, 57, 212, 202, 43],
            Self::Chin => &[200, 199, 175, 152, 201, 208, 171, 148, 176, 140, 32, 194, 211],
            Self::Jaw => &[149, 150, 136, 172, 58, 170, 169, 135, 138, 215, 210, 214, 192, 213],
        }
    }

    /// The part that contains `landmark`.
    pub(crate) fn of(landmark: u32) -> Self {
        let right = landmark.min(mirror_of(landmark));
        let holds = |area: &&Self| area.right_half().iter().any(|&member| u32::from(member) == right);
        *Self::ALL.iter().find(holds).expect("invariant: the parts cover the face")
    }
}
