use glam::DVec3;

use crate::Scale;
use crate::irises::eye_centres;

rosto_mesh::named! {
    /// A facial measurement: the straight distance between two points.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Measure {
        /// Between the sides of the face, in front of the ears.
        FaceWidth = "face-width",
        /// From the topmost landmark of the forehead to the bottom of the chin.
        FaceHeight = "face-height",
        /// Between the centres of the eyes: the pupillary distance for far sight.
        EyeDistance = "eye-distance",
        /// Between the lines of sight of eyes that read at 40 cm, in the plane of spectacles: the pupillary distance for
        /// near sight.
        NearEyeDistance = "near-eye-distance",
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

/// A length with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length {
    /// In metres.
    pub length_m: f64,
    /// Relative standard deviation.
    pub error: f64,
}

/// Half of a normal distribution's 95 % interval, in standard deviations.
const DEVIATIONS: f64 = 1.96;

impl Length {
    /// Half of the 95 % interval, in metres.
    pub fn within_m(self) -> f64 {
        DEVIATIONS * self.error * self.length_m
    }

    /// 95 % interval, in metres.
    pub fn interval_m(self) -> [f64; 2] {
        [self.length_m - self.within_m(), self.length_m + self.within_m()]
    }
}

/// Near pupillary distance relative to the far one: the eyes turn about points 27 mm behind the spectacles, which are
/// 40 cm from the text.
const NEAR_SHARE: f64 = 400.0 / 427.0;

impl Measure {
    /// Length of a face whose size is known to `scale`; `None` if its error exceeds the spread between people, so that
    /// the average person's length would say as much.
    ///
    /// # Panics
    /// See [`Self::of`].
    pub fn length(self, positions_m: &[DVec3], scale: Scale) -> Option<Length> {
        let [landmarks_error, spread] = self.errors();
        let error = scale.error.hypot(landmarks_error);
        (error <= spread).then(|| Length { length_m: self.of(positions_m), error })
    }

    /// Relative standard deviations: of the measure apart from the scale, over heads of known shape, and between adults
    /// (Farkas 1994; Dodgson 2004 for the eyes).
    fn errors(self) -> [f64; 2] {
        match self {
            Self::FaceWidth => [0.05, 0.055],
            Self::FaceHeight => [0.03, 0.068],
            Self::EyeDistance | Self::NearEyeDistance => [0.03, 0.06],
            Self::InnerEyeDistance => [0.04, 0.08],
            Self::OuterEyeDistance => [0.03, 0.05],
            Self::NoseWidth => [0.045, 0.09],
            Self::NoseLength => [0.045, 0.07],
            Self::MouthWidth => [0.035, 0.075],
            Self::JawWidth => [0.035, 0.07],
        }
    }

    /// End landmarks; `None` for the distances between the eyes.
    pub fn landmarks(self) -> Option<[u32; 2]> {
        match self {
            Self::FaceWidth => Some([234, 454]),
            Self::FaceHeight => Some([10, 152]),
            Self::EyeDistance | Self::NearEyeDistance => None,
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
        if self == Self::NearEyeDistance { NEAR_SHARE * a.distance(b) } else { a.distance(b) }
    }
}
