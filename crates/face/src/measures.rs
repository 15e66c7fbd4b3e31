use glam::DVec3;

use crate::irises::eye_centres;

rosto_mesh::named! {
    /// A facial measurement: the straight distance between two points.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Measure {
        /// Between the sides of the face, in front of the ears.
        FaceWidth = "face-width",
        /// From the topmost landmark of the forehead to the bottom of the chin.
        FaceHeight = "face-height",
        /// Between the centres of the eyes.
        EyeDistance = "eye-distance",
        /// Between the inner corners of the eyes.
        InnerEyeDistance = "inner-eye-distance",
        /// Between the outer corners of the eyes.
        OuterEyeDistance = "outer-eye-distance",
        /// Between the wings of the nose.
        NoseWidth = "nose-width",
        /// From the root to the base of the nose.
        NoseLength = "nose-length",
        /// Between the corners of the mouth.
        MouthWidth = "mouth-width",
        /// Between the angles of the jaw.
        JawWidth = "jaw-width",
    }
}

impl Measure {
    /// End landmarks; `None` for the distance between the eye centres.
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

    /// Length in the units of the positions, whose first 468 entries are the landmarks.
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
