use thiserror::Error;

/// Why landmarks are no face that can be modelled.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FaceError {
    /// There are not as many landmarks, or colours, as a face has.
    #[error("{found} {what} where a face has {expected}")]
    WrongCount {
        /// "landmarks" or "colours".
        what: &'static str,
        /// How many a face has.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("landmark {landmark} has a coordinate that is not a finite number")]
    NotFinite {
        /// The landmark.
        landmark: usize,
    },
    /// The picture the landmarks were found in has no area.
    #[error("the picture is {width}×{height} px, which leaves nothing to measure in")]
    EmptyPicture {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
    },
    /// There is no such lens, or it has a number that no camera has.
    #[error("{lens:?} is no lens: estimated, parallel, exif:MM, given:MM (5 to 2000) or distance:M (0.1 to 20)")]
    Lens {
        /// As it was given.
        lens: String,
    },
    /// All landmarks lie on one point or one line, so that the face faces nowhere.
    #[error("the landmarks lie on one line or point, so the face has neither size nor direction")]
    Degenerate,
}
