use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::FaceError;

/// Lens data of a photo. As text: `estimated`, `parallel`, `exif:26`, `given:26` (mm) or
/// `distance:0.35` (m).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PhotoLens {
    /// Nothing: how far away the camera stood is read off the landmarks.
    #[default]
    Estimated,
    /// The camera is taken to stand infinitely far away: landmarks are read as they are.
    Parallel,
    /// The focal length in mm that the photo's EXIF gives, for a frame of 36 × 24 mm. It is set aside where the landmarks
    /// contradict it, as in a picture that was cut out of another.
    Exif(f64),
    /// The focal length in mm for a frame of 36 × 24 mm, as somebody gives it.
    Given(f64),
    /// How far away the camera stood from the face, in m.
    Distance(f64),
}

/// How far a camera can stand from a face, in m: farther away no distance can be told from another.
pub const DISTANCES_M: RangeInclusive<f64> = 0.1..=20.0;
/// Focal lengths for a frame of 36 × 24 mm, in mm.
const FOCAL_LENGTHS_MM: RangeInclusive<f64> = 5.0..=2000.0;

impl PhotoLens {
    /// Refuses numbers that no camera has.
    ///
    /// # Errors
    /// [`FaceError::Lens`].
    pub fn checked(self) -> Result<Self, FaceError> {
        let is_one = match self {
            Self::Estimated | Self::Parallel => true,
            Self::Exif(mm) | Self::Given(mm) => FOCAL_LENGTHS_MM.contains(&mm),
            Self::Distance(m) => DISTANCES_M.contains(&m),
        };
        if is_one { Ok(self) } else { Err(FaceError::Lens { lens: self.to_string() }) }
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
