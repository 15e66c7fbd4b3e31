use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::FaceError;

/// Lens data of a photo. Text form: `estimated`, `parallel`, `exif:26` or `given:26` (mm), `distance:0.35` (m).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PhotoLens {
    /// No data: the distance is estimated from the landmarks.
    #[default]
    Estimated,
    /// Parallel projection: the landmarks are used without perspective correction.
    Parallel,
    /// 35-mm-equivalent focal length in mm from EXIF. Ignored if the landmarks contradict it, as in a crop of another
    /// picture.
    Exif(f64),
    /// 35-mm-equivalent focal length in mm, given by the user.
    Given(f64),
    /// Distance from the camera to the face, in m.
    Distance(f64),
}

/// Range of distances, in m; beyond it, distances cannot be distinguished.
pub const DISTANCES_M: RangeInclusive<f64> = 0.1..=20.0;
/// Range of 35-mm-equivalent focal lengths, in mm.
const FOCAL_LENGTHS_MM: RangeInclusive<f64> = 5.0..=2000.0;

impl PhotoLens {
    /// Checks the ranges.
    ///
    /// # Errors
    /// [`FaceError::Lens`] if a number is out of range.
    pub fn checked(self) -> Result<Self, FaceError> {
        let is_valid = match self {
            Self::Estimated | Self::Parallel => true,
            Self::Exif(mm) | Self::Given(mm) => FOCAL_LENGTHS_MM.contains(&mm),
            Self::Distance(m) => DISTANCES_M.contains(&m),
        };
        if is_valid { Ok(self) } else { Err(FaceError::Lens { lens: self.to_string() }) }
    }
}

impl fmt::Display for PhotoLens {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Estimated => f.write_str("estimated"),
            Self::Parallel => f.write_str("parallel"),
            Self::Exif(mm) => write!(f, "exif:{mm}"),
            Self::Given(mm) => write!(f, "given:{mm}"),
            Self::Distance(m) => write!(f, "distance:{m}"),
        }
    }
}

impl FromStr for PhotoLens {
    type Err = FaceError;

    fn from_str(text: &str) -> Result<Self, FaceError> {
        let unknown = || FaceError::Lens { lens: text.to_owned() };
        let (kind, number) = text.split_once(':').unwrap_or((text, ""));
        let number = || number.parse().map_err(|_| unknown());
        match (kind, text.contains(':')) {
            ("estimated", false) => Ok(Self::Estimated),
            ("parallel", false) => Ok(Self::Parallel),
            ("exif", _) => Self::Exif(number()?).checked(),
            ("given", _) => Self::Given(number()?).checked(),
            ("distance", _) => Self::Distance(number()?).checked(),
            _ => Err(unknown()),
        }
    }
}
