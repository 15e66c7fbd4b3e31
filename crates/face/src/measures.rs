use glam::DVec3;

use crate::irises::eye_centres;

rosto_mesh::named! {
    /// A length that people take of a face, straight from point to point.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Measure {
        /// From temple to temple, before the ears.
        FaceWidth = "face-width",
        /// From the top of the forehead, as far as there are landmarks, to the bottom of the chin.
        FaceHeight = "face-height",
        /// From the middle of one eye to that of the other.
        EyeDistance = "eye-distance",
        /// Between the inner corners of the eyes.
        InnerEyeDistance = "inner-eye-distance",
        /// Between the outer corners of the eyes.
        OuterEyeDistance = "outer-eye-distance",
        /// From wing to wing.
        NoseWidth = "nose-width",
        /// From its root to its base.
        NoseLength = "nose-length",
        /// From corner to corner.
        MouthWidth = "mouth-width",
        /// Between the corners of the jaw.
        JawWidth = "jaw-width",
    }
}

impl Measure {
    /// The landmarks at both ends; none for the middles of the eyes.
    pub fn landmarks(self) -> Option<[u32; 2]> {
        match self {
            Self::FaceWidth => Some([234, 454]),
            Self::FaceHeight => Some([10, 152]),
            Self::EyeDistance => None,
            Self::InnerEyeDistance => Some([133, 362]),
            Self::OuterEyeDistance => Some([33, 263]),
            Self::NoseWidth => Some([129, 358]),
            Self::NoseLength => Some([168, 2]),
            Self::MouthWidth => Some([61, 291]),
            Self::JawWidth => Some([172, 397]),
        }
    }

    /// The length in the units of the positions, the first 468 of which are the landmarks'.
    ///
    /// # Panics
    /// If there are fewer positions than landmarks.
    pub fn of(self, positions: &[DVec3]) -> f64 {
        let [a, b] = match self.landmarks() {
            Some(ends) => ends.map(|end| positions[end as usize]),
            None => eye_centres(positions),
        };
        a.distance(b)
    }
}
