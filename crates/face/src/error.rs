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
    /// There are more photos of the face than are read together, or none.
    #[error("{found} photos of one face; 1 to {most} can be read together")]
    PhotoCount {
        /// How many were given.
        found: usize,
        /// As many as can be read.
        most: usize,
    },
    /// One of several photos shows no face that can be modelled.
    #[error("photo {}: {reason}", photo + 1)]
    InPhoto {
        /// Which, from 0.
        photo: usize,
        /// Why.
        reason: Box<FaceError>,
    },
    /// What one of several photos shows does not agree with the others, however its camera is put: it is another face's.
    #[error(
        "photo {} does not agree with the others: half of its landmarks are {reprojection_px:.1} px and more from where \
         theirs would be, and {most_px:.1} px is the limit; is it the same face?",
        photo + 1
    )]
    AnotherFace {
        /// Which, from 0.
        photo: usize,
        /// The median of how far landmarks are from where the shape would be seen.
        reprojection_px: f64,
        /// As far as that may be.
        most_px: f64,
    },
}
