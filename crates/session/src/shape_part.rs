use rosto_face::Region;
use rosto_studio::FaceSlider;

rosto_mesh::named! {
    /// A part of the face whose controls the panel shows, or a kind of edit.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum ShapePart {
        /// Width and length of the nose.
        #[default]
        Nose = "nose",
        /// Size and distance of the eyes.
        Eyes = "eyes",
        /// The lips.
        Lips = "lips",
        /// Jaw and chin.
        Jaw = "jaw",
        /// The brows.
        Brows = "brows",
        /// Cheekbones, length and symmetry of the whole face.
        Face = "face",
        /// Expressions; in wide windows, a separate section.
        Expressions = "expressions",
        /// Moving points by hand; in wide windows, a separate section.
        Point = "point",
    }
}

impl ShapePart {
    /// Ready-made sliders of the part.
    pub fn sliders(self) -> &'static [FaceSlider] {
        use FaceSlider::*;
        match self {
            Self::Nose => &[NoseWidth, NoseLength],
            Self::Eyes => &[EyeSize, EyeDistance],
            Self::Lips => &[LipFullness],
            Self::Jaw => &[JawWidth, ChinLength],
            Self::Brows => &[BrowHeight],
            Self::Face => &[Cheekbones, FaceLength],
            Self::Expressions | Self::Point => &[],
        }
    }

    /// The part that shapes a region.
    pub fn of(region: Region) -> Self {
        use Region::*;
        match region {
            Nose | NoseBridge | NoseTip | RightNoseWing | LeftNoseWing => Self::Nose,
            RightEye | LeftEye | RightUpperEyelid | LeftUpperEyelid | RightLowerEyelid | LeftLowerEyelid => Self::Eyes,
            Lips | UpperLip | LowerLip => Self::Lips,
            Chin | Jaw | RightJaw | LeftJaw => Self::Jaw,
            RightBrow | LeftBrow => Self::Brows,
            _ => Self::Face,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_slider_belongs_to_one_part() {
        for slider in FaceSlider::ALL {
            let parts = ShapePart::ALL.into_iter().filter(|part| part.sliders().contains(&slider));
            assert_eq!(parts.count(), 1, "{}", slider.id());
        }
    }
}
